// The entry point of the bundle: anywidget renders `widget`; pages of the site call `startViewers`, and `startViewer` for new ones.
export { startViewer, startViewers } from './page-model.js';
export { widget } from './viewer.js';
