// Grammars for editors against the readers: `node editors.mjs MODULES GRAMMARS TEXTS`.
//
// TEXTS has a line of JSON for each text: its kind, the text, and each top statement as the reader cuts it, with its first and last byte
// and what it is. Lezer's trees must have no errors and just these statements. TextMate's grammars, which colour line by line, must
// colour the keyword of each statement, or the arrow of each rule, in texts that are `whole` files. The last line printed says how
// many texts and statements were compared.

import {createRequire} from "node:module"
import {readFileSync} from "node:fs"
import {createInterface} from "node:readline"
import {createReadStream} from "node:fs"

const [modules, grammars, texts] = process.argv.slice(2)
const require = createRequire(modules + "/none.js")
const {buildParser} = require("@lezer/generator")
const onig = require("vscode-oniguruma"), textmate = require("vscode-textmate")

const parsers = {}
for (const kind of ["lsys", "claim"])
    parsers[kind] = buildParser(readFileSync(`${grammars}/lezer/${kind}.grammar`, "utf8"))
await onig.loadWASM(readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm")).buffer)
const registry = new textmate.Registry({
    onigLib: Promise.resolve({
        createOnigScanner: patterns => new onig.OnigScanner(patterns),
        createOnigString: text => new onig.OnigString(text)
    }),
    loadGrammar: async scope => textmate.parseRawGrammar(
        readFileSync(`${grammars}/vscode/${scope.slice(7)}.tmLanguage.json`, "utf8"), "x.json")
})
const colours = {lsys: await registry.loadGrammar("source.lsys"),
                 claim: await registry.loadGrammar("source.claim")}

let count = 0, statements = 0, whole = 0, wrong = 0
const fail = (one, why) => {
    if (++wrong <= 5) console.log(`${why} in ${JSON.stringify(one.text.slice(0, 2000))}`)
}

/// The statements of a tree: name, first and last unit.
function found(tree) {
    const all = []
    for (let child = tree.topNode.firstChild; child; child = child.nextSibling)
        if (![";", "newline", "Comment", "NoColour"].includes(child.name)) all.push([child.name, child.from, child.to])
    return all
}

function coloured(one, said) {
    const lines = one.text.split("\n")
    const scopes = []  // of each unit
    let stack = textmate.INITIAL
    for (const line of lines) {
        const result = colours[one.kind].tokenizeLine(line, stack)
        stack = result.ruleStack
        for (const token of result.tokens)
            for (let i = token.startIndex; i < Math.min(token.endIndex, line.length); ++i)
                scopes.push(token.scopes.join(" "))
        scopes.push("")
    }
    for (const [name, from, to] of said) {
        const text = one.text.slice(from, to)
        if (name === "Rule") {
            const at = text.search(/->|→/)
            if (!scopes[from + at].includes("keyword.operator")) return `no arrow at ${from + at}`
        } else if (!scopes[from].includes("keyword.other")) {
            return `no keyword at ${from}`
        }
    }
    return ""
}

for await (const line of createInterface({input: createReadStream(texts)})) {
    const one = JSON.parse(line)
    ++count
    const bytes = Buffer.from(one.text)
    const ascii = bytes.length === one.text.length
    const unit = byte => ascii ? byte : bytes.subarray(0, byte).toString().length
    const said = one.statements.map(([name, from, to]) => [name, unit(from), unit(to)])
    statements += said.length
    const tree = parsers[one.kind].parse(one.text)
    let error = -1
    tree.iterate({enter: node => { if (node.type.isError && error < 0) error = node.from }})
    if (error >= 0) { fail(one, `an error at ${error}`); continue }
    const seen = found(tree)
    if (JSON.stringify(seen) !== JSON.stringify(said)) {
        fail(one, `${JSON.stringify(seen)} is not ${JSON.stringify(said)}`)
        continue
    }
    if (!one.whole) continue
    ++whole
    const why = coloured(one, said)
    if (why) fail(one, why)
}
console.log(JSON.stringify({count, statements, whole, wrong}))
process.exit(wrong === 0 ? 0 : 1)
