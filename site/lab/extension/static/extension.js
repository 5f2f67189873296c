// What the course adds to the lab in the browser: answers are kept as they are made, what was solved is noted for the page
// of progress, and when the browser cannot do its part, a message says so and what to do. JupyterLab loads this file as a
// prebuilt extension; what it uses of JupyterLab, it takes from there.
(() => {
  'use strict';
  const NAME = 'kinlib-lab';
  const KEY = 'kinlib-course'; // what the pages keep there, course.js says
  const SOLVED = 'application/vnd.kinlib.solved+json';
  const PATIENCE = 60; // in seconds

  const TOLD = {
    wasm: 'Python cannot start here: this browser has no WebAssembly, or it is switched off, as lockdown modes do. Open this page in a current Firefox, Chrome, Edge or Safari. You can still read, type and download.',
    storage:
      'This browser keeps nothing: its storage is full, or the window is private. What you type lasts until you close this tab, so download the notebook before that. To go on later, free some space and save again, or take a window that is not private, and put the file back with Upload, in the folder that the logo leads to.',
    starting:
      'Python is still on its way: 30 MB the first time, from your own disk later. What you type meanwhile is kept.',
    silent: `A cell has been running for ${PATIENCE} seconds. If it may be stuck, restart Python: what you typed stays, and results come back when you run the cells again.`,
    dead: 'Python has stopped. What you typed is still here: restart Python, then run the cells again.',
  };

  let lasts = true; // what is kept, until we know better
  let shared;
  const take = async (name) => (await Object.values(shared[name])[0].get())();
  window._JUPYTERLAB ??= {};
  window._JUPYTERLAB[NAME] = {
    init(scope) {
      shared = scope;
    },
    async get() {
      const packages = ['@jupyterlab/notebook', '@jupyterlab/docmanager', '@jupyterlab/apputils'];
      const [{ INotebookTracker, NotebookActions }, { IDocumentManager }, { Dialog }] = await Promise.all(
        packages.map(take),
      );
      const activate = (app, tracker, manager) => {
        if (typeof WebAssembly !== 'object') tell('wasm');
        const save = ['Download the notebook', () => tracker.currentWidget && download(tracker.currentWidget)];
        lasting().catch(() => {
          lasts = false;
          tell('storage', save);
        }); // then JupyterLite calls kept what it holds in memory
        app.commands.addCommand(`${NAME}:download`, {
          label: 'Download',
          caption: 'Download this notebook as it stands, to hand it in or to keep it',
          execute: () => download(tracker.currentWidget),
        });
        tracker.widgetAdded.connect((_, panel) => {
          watch(panel);
          panel.context.saveState.connect((__, state) => {
            if (state === 'failed') {
              manager.autosave = false; // or a dialog would come between every two words
              setTimeout(() => Dialog.flush());
              tell('storage', save);
            } else if (state.startsWith('completed') && lasts) {
              manager.autosave = true;
              untell('storage');
            }
          });
        });
        NotebookActions.executed.connect((_, { cell }) => note(cell));
      };
      return () => ({
        __esModule: true,
        default: { id: `${NAME}:plugin`, autoStart: true, requires: [INotebookTracker, IDocumentManager], activate },
      });
    },
  };

  // --- answers ---

  function watch(panel) {
    const { context, sessionContext } = panel;
    const keep = () => context.model.dirty && context.save().catch(() => {});
    const restart = [
      'Restart Python',
      () => {
        untell('silent', 'dead', 'starting');
        sessionContext.restartKernel();
      },
    ];
    let heard = false;
    let waiting;

    document.addEventListener('visibilitychange', () => document.hidden && keep());

    sessionContext.statusChanged.connect((_, status) => {
      clearTimeout(waiting);
      heard ||= status === 'idle';
      if (status === 'busy' || status === 'starting') {
        waiting = setTimeout(() => (heard ? tell('silent', restart) : tell('starting')), PATIENCE * 1000);
      } else if (status === 'dead') tell('dead', restart);
      else untell('silent', 'dead', 'starting');
    });
  }

  /** Whether anything can be kept: some private windows refuse to open the store, some only to write. */
  function lasting() {
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

  /** The notebook as it stands on the screen, as a file: what cannot be kept can still be taken away. */
  function download({ context, content }) {
    const text = JSON.stringify(content.model.toJSON(), null, 1);
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([text], { type: 'application/x-ipynb+json' }));
    link.download = context.path.split('/').pop();
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  // --- progress ---

  /** Remember a problem whose check gave full marks. It is for the reader's eyes: whoever grades runs the sheet anew. */
  function note(cell) {
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
      /* it is not kept, as the message about storage says */
    }
  }

  // --- messages ---

  const board = document.createElement('div');
  board.style.cssText =
    'position:fixed;z-index:10000;left:50%;bottom:1rem;transform:translateX(-50%);width:min(44rem,94vw);display:grid;gap:.5rem;font:15px/1.45 system-ui,sans-serif';
  board.setAttribute('role', 'alert');
  document.body.append(board);

  function tell(name, ...actions) {
    if (board.querySelector(`[data-told="${name}"]`)) return;
    const card = document.createElement('div');
    card.dataset.told = name;
    card.style.cssText =
      'background:#fff8e6;color:#1f2328;border:1px solid #8a5a00;border-left-width:6px;border-radius:.4rem;padding:.7rem 1rem;box-shadow:0 4px 18px #0004';
    card.append(TOLD[name], document.createElement('br'));
    for (const [label, act] of [...actions, ['Close', () => untell(name)]]) {
      const button = document.createElement('button');
      button.textContent = label;
      button.style.cssText =
        'margin:.5rem .5rem 0 0;padding:.25rem .8rem;font:inherit;color:inherit;background:#fff;border:1px solid #8a5a00;border-radius:.3rem;cursor:pointer';
      button.onclick = act;
      card.append(button);
    }
    board.append(card);
  }

  function untell(...names) {
    for (const name of names) board.querySelector(`[data-told="${name}"]`)?.remove();
  }
})();
