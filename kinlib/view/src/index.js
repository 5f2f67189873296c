// The one entry of the bundle: `widget` is what anywidget renders, `wake` is for pages without a kernel.
export { wake } from './static.js';
export { widget } from './viewer.js';
