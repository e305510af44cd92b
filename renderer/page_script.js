// An element with attributes and children; texts become text nodes, so no name can be markup. `svg` makes it one of
// SVG where its name does not tell.
function make(tag, attributes = {}, ...children) {
  const of_svg = attributes.svg || ["svg", "rect", "line", "title"].includes(tag);
  const element = of_svg ? document.createElementNS("http://www.w3.org/2000/svg", tag) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) if (name !== "svg") element.setAttribute(name, value);
  element.append(...children);
  return element;
}
