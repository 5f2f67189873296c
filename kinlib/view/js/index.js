// The entry point of the bundle: anywidget renders `widget`; pages without a kernel call `startViewers`.
export { startViewers } from './static-page.js';
export { widget } from './viewer.js';
