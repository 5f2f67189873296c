// The model of a widget, that of anywidget or a PageModel: its traits are shared with Python.

/** Set a trait, and send it to Python. */
export function save(model, name, value) {
  model.set(name, value);
  model.save_changes();
}

/** Call functions when the traits of their names change. Returns a function that stops this. */
export function listen(model, listeners) {
  const entries = Object.entries(listeners);
  for (const [name, listener] of entries) model.on(`change:${name}`, listener);
  return () => {
    for (const [name, listener] of entries) model.off(`change:${name}`, listener);
  };
}
