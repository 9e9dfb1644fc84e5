/* The theme's search: a question is split into words as the pages are (mkdocs.yml, separator), so that solid.spacing
   finds the key. A page that a browser opened from a folder may not fetch the index; it loads it as a script. */
var __search = {
  transform: function (question) { return question.replace(/[\s\-.,:;=/(){}\[\]"`|]+/g, " ").trim(); }
};
if (location.protocol === "file:")
  document.write('<script src="' + document.currentScript.src.replace(/[^/]*$/, "local.js") + '"><\/script>');
