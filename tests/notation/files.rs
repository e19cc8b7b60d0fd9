//! Files: what in Markdown, LaTeX and notebooks is a formula, what is text, and what is neither.

use super::outline::{self, document};
use polhode::notation::document::{Document, Format, Item, Row};
use polhode::notation::read;

fn prose(document: &Document) -> String {
    let words = document.items.iter().filter_map(|item| match item {
        Item::Prose { text, .. } => Some(text.as_str()),
        _ => None,
    });
    words.collect()
}

#[test]
fn markdown_has_formulas_between_many_marks() {
    for text in [
        "Then $a = b$.",
        "Then $ a = b $ holds.",
        "Then \\(a = b\\).",
        "$$\na = b\n$$",
        "And $$a = b$$ in the text.",
        "\\[\na = b\n\\]",
        "\\\\[ a = b \\\\]",
        "\\\\( a = b \\\\)",
        "```math\na = b\n```",
        "```{math}\n:label: euler\na = b\n```",
        "$`a = b`$",
        "\\begin{align}\na = b\n\\end{align}",
        "> [!note]\n> $$\n> a\n> = b\n> $$",
        "- item\n\n  $$\n  a = b\n  $$",
        "| a | b |\n| --- | --- |\n| c | $a = b$ |",
        "1. first $a = b$",
        "<div>\n$$ a = b $$\n</div>",
        "note[^1]\n\n[^1]: $a = b$",
        "*so $a = b$*",
        "It costs \\$5, then $a = b$.",
        "It costs $5 and $10. See $a = b$",
        "Money: $5 to $10; $a = b$.",
        ".. math:: a = b\n\nAnd so on.",
        ".. math::\n   :label: euler\n\n   a = b\n\nAnd so on.",
        "So :math:`a = b` holds.",
        "1. first\n\n   .. math::\n\n      a\n      = b\n\n   and so on",
    ] {
        assert_eq!(document(text, Format::Markdown), "a = b", "{text}");
    }
}

#[test]
fn underscores_stars_and_backslashes_in_a_formula_are_its_own() {
    let text = "$a_i*b_i = c_i*d_i$ and $$\\begin{aligned} e_1 &= f_1 \\\\ g_1 &= h_1 \\end{aligned}$$ and $I\\_{xx}\\*2$";
    assert_eq!(
        document(text, Format::Markdown),
        "(* a_i b_i) = (* c_i d_i)\ne_1 = f_1\ng_1 = h_1\n(* I_xx 2)"
    );
}

#[test]
fn code_and_comments_are_no_formulas() {
    for text in [
        "`$a = b$`",
        "``$a = b$ ` ``",
        "```python\n$$a = b$$\n```",
        "~~~\n$a = b$\n~~~",
        "<!-- $a = b$ -->",
        "```\n$a = b$\n",
    ] {
        assert_eq!(document(text, Format::Markdown), "", "{text}");
    }
    let latex =
        "\\verb|$a = b$| \\begin{verbatim}$a = b$\\end{verbatim} % $a = b$\n\\iffalse $a = b$ \\fi";
    assert_eq!(document(latex, Format::Latex), "");
}

#[test]
fn names_behind_a_display_are_labels() {
    for text in ["$$a = b$$ {#eq-euler}", "$$\na = b\n$$ {#eq-euler}\n"] {
        let (read, _) = read("a.md", text, Format::Markdown);
        assert_eq!(outline::formulas(&read), "a = b #eq-euler", "{text}");
        assert_eq!(prose(&read).trim(), "", "{text}");
    }
    assert_eq!(
        document("$$a = b$$ (eq:foo)", Format::Markdown),
        "a = b #eq:foo"
    );
}

#[test]
fn words_keep_their_order_around_formulas() {
    let text = "Assume **that** $a = b$, [see $c$](x.md). eq<sup>n</sup> (3) gives\n$$d = e \\text{ where } f = g$$\n";
    let (read, troubles) = read("a.md", text, Format::Markdown);
    assert_eq!(troubles, []);
    let order: Vec<String> = read
        .items
        .iter()
        .filter_map(|item| match item {
            Item::Prose { text, .. } => Some(text.clone()),
            Item::Formula(formula) => Some(format!("⟨{}⟩", outline::rows(&formula.rows))),
            _ => None,
        })
        .collect();
    assert_eq!(
        order.concat(),
        "Assume that ⟨a = b⟩, see ⟨c⟩. eqn (3) gives ⟨d = e⟩ where ⟨f = g⟩"
    );
}

#[test]
fn a_macro_may_be_an_exponent() {
    let own = r"\newcommand{\tr}{^{\mathsf T}} $R\tr R = 1$";
    assert_eq!(
        document(own, Format::Latex),
        document(r"$R^{\mathsf T} R = 1$", Format::Latex)
    );
}

#[test]
fn what_a_macro_stands_for_has_the_place_of_its_call() {
    let text =
        r"\newcommand{\om}{\boldsymbol\omega}\newcommand{\dd}[1]{\frac{d#1}{dt}} $\dd{L} = J\om$";
    let (document, _) = read("a.tex", text, Format::Latex);
    let lines = document.items.iter().find_map(|item| match item {
        Item::Formula(formula) => Some(&formula.rows),
        _ => None,
    });
    let Some([Row::Line(line)]) = lines.map(Vec::as_slice) else {
        panic!("one line stands there");
    };
    let sides: Vec<&str> = line
        .sides
        .iter()
        .map(|side| document.source.slice(side.span))
        .collect();
    assert_eq!(sides, [r"\dd{L}", r"J\om"]);
}

#[test]
fn a_latex_file_is_read_with_its_own_macros() {
    let text = r"\documentclass{article}
% polhode: products: entries
\newcommand{\om}{\boldsymbol\omega}
\newcommand{\dd}[2]{\frac{\mathrm d #1}{\mathrm d #2}}
\newcommand{\pos}[1][r]{\vec #1}
\def\half{\tfrac12}
\let\eps\epsilon
\DeclareMathOperator{\sk}{skew}
\newcommand\be{\begin{equation}}
\newcommand\ee{\end{equation}}
\begin{document}
\section{The equation $L = I\omega$}
Assume $I_{xy} = 0$. % not $x = y$
\begin{equation}\label{eq:one}
 \mathbf M = \dd{\mathbf L}{t} + \om\times\mathbf L
\end{equation}
\be T = \half \om\cdot\mathbf L \ee
$\pos = \pos[s]$, $\eps = \sk(\om)$
\begin{align} a &= b \label{a}\\ \intertext{so that} c &= d \end{align}
$$ g = h \eqno(4) $$
\end{document}
$after = end$";
    let (read, troubles) = read("a.tex", text, Format::Latex);
    assert_eq!(troubles, []);
    assert_eq!(read.front_matter.products.as_deref(), Some("entries"));
    let expected = "\
I_xy = 0
vec:M = (+ (d/dt vec:L) (* vec:omega × vec:L)) #eq:one
T = (* (/ 1 2) vec:omega · vec:L)
vec:r = vec:s
epsilon = (skew vec:omega)
a = b #a
c = d
g = h #(4)";
    assert_eq!(outline::formulas(&read), expected);
    assert!(prose(&read).contains("so that"), "{}", prose(&read));
    let heading = read.items.iter().find_map(|item| match item {
        Item::Heading { text, .. } => Some(text.as_str()),
        _ => None,
    });
    assert_eq!(heading, Some("The equation L = Iomega"));
}

#[test]
fn an_included_file_is_not_read_and_that_is_said() {
    let (_, troubles) = read("a.tex", "\\input{other} $a = b$", Format::Latex);
    assert_eq!(troubles.len(), 1);
    assert!(troubles[0].message.contains("only this one"));
}

#[test]
fn a_notebook_gives_its_markdown_cells_with_their_index() {
    let text = r##"{"cells": [
        {"cell_type": "code", "source": ["a = 1\n"]},
        {"cell_type": "markdown", "source": ["# T\n", "\\begin{align}\n", "a &= b \\\\\n", "c &= d\n", "\\end{align}\n"]},
        {"cell_type": "raw", "source": "$q = r$"},
        {"cell_type": "markdown", "source": "Then $e = f$."}]}"##;
    let (read, troubles) = read("a.ipynb", text, Format::Notebook);
    assert_eq!(troubles, []);
    assert_eq!(outline::formulas(&read), "a = b\nc = d\ne = f");
    let cells: Vec<usize> = read.cells.iter().map(|cell| cell.index).collect();
    assert_eq!(cells, [1, 3]);
}

#[test]
fn a_row_begins_where_its_first_sign_stands() {
    let text = "Text\n\n$$\n\\begin{aligned}\n  a &= b \\\\\n    &= c \\\\[2pt]\n\n  d &= e\n\\end{aligned}\n$$\n";
    let (read, _) = read("a.md", text, Format::Markdown);
    let mut lines = vec![];
    for item in &read.items {
        if let Item::Formula(formula) = item {
            for row in &formula.rows {
                if let Row::Line(line) = row {
                    lines.push(read.source.line_column(line.span.start));
                }
            }
        }
    }
    assert_eq!(lines, [(5, 3), (6, 6), (8, 3)]);
}

#[test]
fn definitions_inside_a_formula_state_nothing() {
    let text = "$$\\newcommand{\\om}{\\boldsymbol\\omega}\\def\\half{\\tfrac12} \\om = \\half$$";
    assert_eq!(document(text, Format::Markdown), "vec:omega = (/ 1 2)");
}

#[test]
fn a_directive_holds_formulas_that_blank_lines_part() {
    let text = "So\n\n.. math::\n   :label: two\n\n   a = b\n\n   \\begin{aligned}\n   c &= d\n\n   &= e\n   \\end{aligned}\n\nand on.\n";
    let (document, _) = read("a.rst", text, Format::Markdown);
    let formulas = document
        .items
        .iter()
        .filter(|item| matches!(item, Item::Formula(_)));
    assert_eq!(formulas.count(), 2);
    let (plain, _) = read("a.txt", text, Format::Text);
    assert_eq!(plain.items.len(), document.items.len());
    assert!(prose(&document).contains("and on."));
}

#[test]
fn blocks_of_text_are_no_code() {
    let text = "````{prf:theorem} Steiner\n:label: steiner\n\n```{index} axis\n```\nThen\n\n$$\na = b\n$$ (one)\n````\n\n\
                ```{note}\nHere $c = d$.\n```\n\n```{code-cell} ipython3\ne = '$f = g$'\n```\n";
    let (document, _) = read("a.md", text, Format::Markdown);
    let formulas = document
        .items
        .iter()
        .filter(|item| matches!(item, Item::Formula(_)));
    assert_eq!(formulas.count(), 2);
    assert!(prose(&document).contains("Then"));
    assert!(!prose(&document).contains("steiner"));
}

#[test]
fn code_that_is_mathematics_in_unicode_is_read() {
    let text = "The rate is `ṗ = q·r`, by `p = 3` and `f(x)`.\n\n```\nu̇ = −g·sinθ − Q·w\nv̇ = g·cosθ\n```\n\n\
                | a | b |\n|---|---|\n| name | `Ω = Ṙ Rᵀ` |\n\n```python\nω = 3\n```\n";
    let (document, _) = read("a.md", text, Format::Markdown);
    let rows = document.items.iter().filter_map(|item| match item {
        Item::Formula(formula) => Some(&formula.rows),
        _ => None,
    });
    let mut lines = vec![];
    for row in rows.flatten() {
        if let Row::Line(line) = row {
            lines.push(document.source.line_column(line.span.start).0);
        }
    }
    assert_eq!(lines, [1, 4, 5, 10]);
}
