// The one entry of the bundle: `widget` is what anywidget renders, `startViewers` is for pages without a kernel.
export { startViewers } from './static-page.js';
export { widget } from './viewer.js';
