// What the course adds to the lab in the browser: a Download button, a way back to the page, a record of solved problems for the
// page of progress, and a message if the browser cannot store what is typed. JupyterLab loads this file as a prebuilt extension.
(() => {
  'use strict';
  const NAME = 'kinlib-lab';
  const KEY = 'kinlib-course'; // in localStorage; course.js describes the record
  const SOLVED = 'application/vnd.misstep.solved+json';

  const LOST =
    'This browser cannot store your work, because its storage is full or the window is private. What you type ' +
    'is lost when you close this tab, so download the notebook first. To continue later, free some space and save ' +
    'again, or use a window that is not private and upload the file there, ' +
    'in the folder that File > Open shows.';

  let storageWorks = true; // until a test or a failed save shows the contrary
  let shared;
  const resolveShared = async (name) => (await Object.values(shared[name])[0].get())();
  window._JUPYTERLAB ??= {};
  window._JUPYTERLAB[NAME] = {
    init(scope) {
      shared = scope;
    },
    async get() {
      const packages = ['@jupyterlab/notebook', '@jupyterlab/docmanager', '@jupyterlab/apputils'];
      const [{ INotebookTracker, NotebookActions }, { IDocumentManager }, { Dialog }] = await Promise.all(
        packages.map(resolveShared),
      );
      const activate = (app, tracker, manager) => {
        const warn = () => showMessage(() => tracker.currentWidget && download(tracker.currentWidget));
        // without storage, JupyterLite reports as saved what is only in memory
        testStorage().catch(() => {
          storageWorks = false;
          warn();
        });
        app.commands.addCommand(`${NAME}:download`, {
          label: 'Download',
          caption: 'Download this notebook in its present state, to hand it in or to keep it',
          execute: () => download(tracker.currentWidget),
        });
        const { folder, name } = pageOf(new URLSearchParams(location.search).get('path') ?? '');
        app.commands.addCommand(`${NAME}:page`, {
          label: folder === 'lectures' ? 'Back to the lecture' : 'Back to the page',
          caption: 'Save the notebook, and open its page on the site',
          isVisible: () => Boolean(name),
          execute: async () => {
            await tracker.currentWidget?.context.save().catch(() => {});
            location.href = `../../${folder}/${name}.html`;
          },
        });
        tracker.widgetAdded.connect((_, panel) => {
          document.addEventListener('visibilitychange', () => document.hidden && panel.context.save().catch(() => {}));
          panel.context.saveState.connect((__, state) => {
            if (state === 'failed') {
              manager.autosave = false; // otherwise a dialog would interrupt the typing again and again
              setTimeout(() => Dialog.flush());
              warn();
            } else if (state.startsWith('completed') && storageWorks) {
              manager.autosave = true;
              message.hidden = true;
            }
          });
        });
        NotebookActions.executed.connect((_, { cell }) => recordSolved(cell));
      };
      return () => ({
        __esModule: true,
        default: { id: `${NAME}:plugin`, autoStart: true, requires: [INotebookTracker, IDocumentManager], activate },
      });
    },
  };

  /** The page of the site that shows the notebook of a path. */
  function pageOf(path) {
    const [, folder, name] = path.match(/^(notebooks|exercises)\/(?:.*\/)?(\w+)\.ipynb$/) ?? [];
    return { folder: folder === 'notebooks' ? 'lectures' : 'sheets', name };
  }

  /** Test whether anything can be stored: some private windows cannot open a database, others cannot write to it. */
  function testStorage() {
    return new Promise((resolve, reject) => {
      const opened = indexedDB.open(NAME, 1);
      opened.onupgradeneeded = () => opened.result.createObjectStore('probe');
      opened.onerror = reject;
      opened.onsuccess = () => {
        const written = opened.result.transaction('probe', 'readwrite');
        written.objectStore('probe').put(1, 'x');
        written.oncomplete = resolve;
        written.onerror = written.onabort = reject;
      };
    });
  }

  /** Download the notebook in its present state, so that nothing is lost even if it cannot be stored. */
  function download({ context, content }) {
    const text = JSON.stringify(content.model.toJSON(), null, 1);
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([text], { type: 'application/x-ipynb+json' }));
    link.download = context.path.split('/').pop();
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  // --- progress ---

  /** Record the problems whose check gave full marks, for the reader only: grading runs the sheet again. */
  function recordSolved(cell) {
    const outputs = cell.model.outputs?.toJSON() ?? [];
    const solved = outputs
      .map(({ data }) => data?.[SOLVED])
      .filter(Boolean)
      .map(({ sheet, problem }) => `${sheet}/${problem}`);
    if (!solved.length) return;
    try {
      const kept = JSON.parse(localStorage.getItem(KEY)) ?? {};
      const before = Array.isArray(kept.solved) ? kept.solved : [];
      localStorage.setItem(KEY, JSON.stringify({ ...kept, solved: [...new Set([...before, ...solved])] }));
    } catch {
      /* nothing is stored, as the message about storage says */
    }
  }

  // --- the message about storage ---

  const message = document.createElement('div');
  message.style.cssText =
    'position:fixed;z-index:10000;left:50%;bottom:1rem;transform:translateX(-50%);width:min(44rem,94vw);' +
    'padding:.7rem 1rem;font:15px/1.45 system-ui,sans-serif;background:#fff8e6;color:#1f2328;box-shadow:0 4px 18px #0004';
  message.setAttribute('role', 'alert');
  message.hidden = true;
  document.body.append(message);

  function showMessage(save) {
    const hide = () => {
      message.hidden = true;
    };
    const buttons = Object.entries({ 'Download the notebook': save, Close: hide });
    const made = buttons.map(([label, act]) =>
      Object.assign(document.createElement('button'), { textContent: label, onclick: act }),
    );
    message.replaceChildren(LOST, document.createElement('br'), ...made);
    message.hidden = false;
  }
})();
