// What the course adds to the lab in the browser: answers are saved as they are made, solved problems are recorded for
// the page of progress, and if the browser cannot run or store something, a message says what to do. JupyterLab loads
// this file as a prebuilt extension and provides its own packages.
(() => {
  'use strict';
  const NAME = 'kinlib-lab';
  const KEY = 'kinlib-course'; // in localStorage; course.js describes the record
  const SOLVED = 'application/vnd.misstep.solved+json';
  const SECTION = 'kinlib-section'; // in localStorage, from a click on a link until the notebook is open
  const RENDERING_MS = 500; // between two looks at a notebook whose cells still change their height
  const SETTLED_S = 60; // after which no cell changes its height by itself
  const ACTS = ['wheel', 'touchstart', 'pointerdown', 'keydown']; // with these, readers decide themselves what they see
  const SILENCE_S = 60; // without a result, until a message is shown

  const MESSAGES = {
    wasm:
      'Python cannot start, because this browser has no WebAssembly or has it switched off, for example in a ' +
      'lockdown mode. Open this page in a current Firefox, Chrome, Edge or Safari. ' +
      'Here you can still read, type and download.',
    storage:
      'This browser cannot store your work, because its storage is full or the window is private. What you type ' +
      'is lost when you close this tab, so download the notebook first. To continue later, free some space and save ' +
      'again, or use a window that is not private and upload the file there, ' +
      'in the folder that File > Open shows.',
    silent:
      `A cell has been running for ${SILENCE_S} seconds. If it does not end, restart Python: what you typed is kept, ` +
      'and the results return when you run the cells again.',
    dead: 'Python has stopped. What you typed is still here: restart Python, then run the cells again.',
  };

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
        if (typeof WebAssembly !== 'object') showMessage('wasm');
        const save = ['Download the notebook', () => tracker.currentWidget && download(tracker.currentWidget)];
        // without storage, JupyterLite reports as saved what is only in memory
        testStorage().catch(() => {
          storageWorks = false;
          showMessage('storage', save);
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
        document.addEventListener('click', rememberSection, true);
        tracker.widgetAdded.connect((_, panel) => {
          watchKernel(panel);
          showSection(panel);
          panel.context.saveState.connect((__, state) => {
            if (state === 'failed') {
              manager.autosave = false; // otherwise a dialog would interrupt the typing again and again
              setTimeout(() => Dialog.flush());
              showMessage('storage', save);
            } else if (state.startsWith('completed') && storageWorks) {
              manager.autosave = true;
              hideMessages('storage');
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

  // --- links to a section of a lecture: the lab opens the notebook in another window, and forgets the section ---

  function rememberSection(event) {
    const link = event.target.closest?.('a[href*=".ipynb"]');
    if (link?.hash && storageWorks) localStorage.setItem(SECTION, link.hash);
  }

  async function showSection(panel) {
    const section = storageWorks && localStorage.getItem(SECTION);
    if (!section) return;
    localStorage.removeItem(SECTION);
    await panel.revealed;
    // pictures and formulas above the section are drawn later, so that one scroll is not enough on a slow machine
    const repeated = setInterval(() => panel.setFragment(section), RENDERING_MS);
    const stop = () => clearInterval(repeated);
    setTimeout(stop, SETTLED_S * 1000);
    for (const act of ACTS) document.addEventListener(act, stop, { capture: true, once: true });
  }

  // --- answers ---

  function watchKernel(panel) {
    const { context, sessionContext } = panel;
    const save = () => context.model.dirty && context.save().catch(() => {});
    const restart = [
      'Restart Python',
      () => {
        hideMessages('silent', 'dead');
        sessionContext.restartKernel();
      },
    ];
    let waiting;

    document.addEventListener('visibilitychange', () => document.hidden && save());

    sessionContext.kernelChanged.connect((_, { newValue }) => newValue && reportPython('chosen'));
    sessionContext.statusChanged.connect((_, status) => {
      clearTimeout(waiting);
      // start.js shows how Python starts, from before JupyterLab is there until the kernel answers
      if (status === 'idle' || status === 'busy') reportPython('ready');
      if (status === 'starting' || status === 'restarting' || status === 'autorestarting') reportPython('starting');
      if (status === 'busy') waiting = setTimeout(() => showMessage('silent', restart), SILENCE_S * 1000);
      else if (status === 'dead') showMessage('dead', restart);
      else hideMessages('silent', 'dead');
    });
  }

  const reportPython = (detail) => document.dispatchEvent(new CustomEvent('kinlib-python', { detail }));

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

  // --- messages ---

  const messages = document.createElement('div');
  messages.style.cssText =
    'position:fixed;z-index:10000;left:50%;bottom:1rem;transform:translateX(-50%);' +
    'width:min(44rem,94vw);display:grid;gap:.5rem;font:15px/1.45 system-ui,sans-serif';
  messages.setAttribute('role', 'alert');
  document.body.append(messages);

  function showMessage(name, ...actions) {
    if (messages.querySelector(`[data-message="${name}"]`)) return;
    const card = document.createElement('div');
    card.dataset.message = name;
    card.style.cssText =
      'background:#fff8e6;color:#1f2328;border:1px solid #8a5a00;border-left-width:6px;' +
      'border-radius:.4rem;padding:.7rem 1rem;box-shadow:0 4px 18px #0004';
    card.append(MESSAGES[name], document.createElement('br'));
    for (const [label, act] of [...actions, ['Close', () => hideMessages(name)]]) {
      const button = document.createElement('button');
      button.textContent = label;
      button.style.cssText =
        'margin:.5rem .5rem 0 0;padding:.25rem .8rem;font:inherit;color:inherit;background:#fff;' +
        'border:1px solid #8a5a00;border-radius:.3rem;cursor:pointer';
      button.onclick = act;
      card.append(button);
    }
    messages.append(card);
  }

  function hideMessages(...names) {
    for (const name of names) messages.querySelector(`[data-message="${name}"]`)?.remove();
  }
})();
