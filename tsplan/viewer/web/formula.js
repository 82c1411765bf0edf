/* The formula as a tree of buttons that tick off as time goes on. */

class FormulaTree {
  constructor(nodes, choice) {
    this.nodes = nodes;
    this.choice = choice;
    this.rows = [];
    const tree = document.getElementById("formula");
    nodes.forEach((node, n) => tree.append(this.row(node, n)));
    tree.hidden = nodes.length === 0;
  }

  row(node, n) {
    const button = element("button");
    button.type = "button";
    button.style.paddingInlineStart = `${6 + 14 * Math.min(node.depth, 12)}px`;
    button.setAttribute("aria-pressed", "false");
    const mark = element("span", "mark");
    mark.setAttribute("aria-hidden", "true");
    const status = element("span", "unseen");
    button.append(mark, element("span", "text", node.heading), element("span", "when", node.when), status);
    button.addEventListener("click", () => this.choice.chooseNode(n));
    this.rows.push({ button, mark, status, shown: "" });
    return button;
  }

  /* How much of what a node has to fulfil is certain at a time, and whether it has failed. */
  progress(node, time) {
    if (node.failed !== null && time >= node.failed) return { kind: "failed", share: 0 };
    if (node.duties === 0) return { kind: "unneeded", share: 0 };
    let done = 0;
    for (const [step, duties] of node.settled) {
      if (step > time) break;
      done += duties;
    }
    if (done >= node.duties) return { kind: "done", share: 1 };
    return { kind: done ? "running" : "open", share: done / node.duties };
  }

  update(time) {
    const words = { failed: "failed", unneeded: "not needed", done: "fulfilled", running: "under way", open: "open" };
    this.nodes.forEach((node, n) => {
      const { kind, share } = this.progress(node, time);
      const row = this.rows[n];
      const shown = `${kind} ${share.toFixed(2)}`;
      if (row.shown === shown) return;
      row.shown = shown;
      row.mark.className = `mark ${kind}`;
      row.mark.style.setProperty("--share", share.toFixed(3));
      row.status.textContent = words[kind];
      row.button.title = words[kind];
    });
  }

  /* What a node's mark says at a time: open, running, done, failed or unneeded. */
  status(n, time) { return this.progress(this.nodes[n], time).kind; }

  showChoice() {
    this.rows.forEach((row, n) => row.button.setAttribute("aria-pressed", String(n === this.choice.node)));
    const row = this.rows[this.choice.node];
    if (row) row.button.scrollIntoView({ block: "nearest" });
  }
}
