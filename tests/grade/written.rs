//! What is written of a class and of each student, whatever stands in their names and in their work.

use super::{KEY, LAW, key, marked};
use polhode::grade::{Graded, Marks};
use polhode::report::grade::class::{Tally, page};
use polhode::report::grade::gradebook::{Form, row_of_class};
use polhode::report::grade::table::rows;
use polhode::report::grade::told::Detail;
use polhode::report::grade::{markdown, page as html};

/// The page of a class with these marks, of a key with so many at most.
fn page_of(most: &str, marks: &[f64]) -> String {
    let key = key(&KEY.replace("\"(1)\": 1,", &format!("\"(1)\": {most},")));
    let (mut tally, student) = (Tally::default(), marked(LAW));
    for &number in marks {
        let marks = Marks::new(number).expect("a number of marks");
        tally.add(&Graded {
            marks,
            queue: None,
            questions: vec![],
            ..student.clone()
        });
    }
    written(&tally, &key)
}

fn written(tally: &Tally, key: &polhode::grade::Key) -> String {
    let mut text = vec![];
    page(key, tally, |_| Ok(marked(LAW)), &[], &mut text).expect("written");
    String::from_utf8(text).expect("text")
}

/// The bars of a distribution of marks that stand for somebody.
fn bars(page: &str) -> Vec<(String, usize)> {
    let (_, behind) = page.split_once("<h2>Marks</h2>").expect("a heading");
    let (svg, _) = behind.split_once("</svg>").expect("a drawing");
    let texts = svg.split("<text").skip(1).map(|text| {
        let (_, text) = text.split_once('>').expect("a tag");
        text.split_once('<').map_or(text, |(text, _)| text)
    });
    let texts: Vec<_> = texts.collect();
    let bars = texts.chunks(2).map(|bar| {
        let count = bar[1].parse().expect("a count");
        (bar[0].to_owned(), count)
    });
    bars.filter(|(_, count)| *count > 0).collect()
}

#[test]
fn every_mark_has_a_bar_with_a_plain_name() {
    let bar = |name: &str, count| (name.to_owned(), count);
    // The other milestones of the key are worth seven.
    assert_eq!(
        bars(&page_of("1", &[0.0, 5.0, 8.0, 8.0])),
        [bar("0", 1), bar("5", 1), bar("8", 2)]
    );
    assert_eq!(
        bars(&page_of("1", &[7.5, 8.0])),
        [bar("7 to 8", 1), bar("8", 1)]
    );
    assert_eq!(bars(&page_of("43", &[49.0])), [bar("45 to 50", 1)]);
}

#[test]
fn the_middle_of_a_class() {
    for (marks, middle) in [
        (&[1.0, 2.0, 6.0][..], "mean 3, median 2."),
        (&[1.0, 2.0], "mean 1.5, median 1.5."),
        (&[], "mean 0, median 0."),
    ] {
        let page = page_of("1", marks);
        assert!(page.contains(middle), "{marks:?}: {page}");
    }
}

#[test]
fn no_more_questions_are_kept_than_a_person_would_read() {
    let mut tally = Tally::default();
    let asking = |questions| Graded {
        questions,
        ..marked(LAW)
    };
    let question = |number: usize| (format!("what is `x_{number}`?"), 1);
    tally.add(&asking((0..10_005).map(question).collect()));
    tally.add(&asking(vec![("what is `x_0`?".to_owned(), 2)]));
    let page = written(&tally, &key(KEY));
    assert_eq!(page.matches(" line waits.").count(), 9_999);
    assert!(page.contains(" It stands in 2 submissions; 3 lines wait."));
    assert!(page.contains("No more questions are listed."));
}

#[test]
fn no_cell_of_a_gradebook_is_a_formula() {
    let key = key(KEY);
    let row = |id: &str| {
        let student = Graded {
            id: id.to_owned(),
            ..marked(LAW)
        };
        row_of_class(Form::Csv, &key, &student, Detail::Full)
    };
    assert!(row("=HYPERLINK(\"x\")").starts_with("\"'=HYPERLINK(\"\"x\"\")\","));
    for formula in ["+1", "-1", "@a", "\t=1", "  =1", "|x"] {
        assert!(row(formula).starts_with("\"'"), "{formula}");
    }
    assert!(row("a,b").starts_with("\"a,b\","));
    assert!(row("s017").starts_with("s017,"));
}

#[test]
fn a_quoted_cell_may_hold_commas_quotes_and_line_breaks() {
    let values = |text: &str| -> Vec<_> { rows(text).map(|row| row.values(text)).collect() };
    assert_eq!(
        values("\u{feff}id,name\r\n1,\"a, \"\"b\"\"\nc\"\r\n\r\n2,\n"),
        [vec!["id", "name"], vec!["1", "a, \"b\"\nc"], vec!["2", ""]]
    );
    assert_eq!(values("a;b\n1,5;2\n"), [vec!["a", "b"], vec!["1,5", "2"]]);
}

/// A student of whom one line is shown.
fn of_line(source: &str) -> Graded {
    let mut student = marked(LAW);
    student.lines.truncate(1);
    source.clone_into(&mut student.lines[0].source);
    student
}

#[test]
fn nothing_in_a_text_marks_anything_up() {
    let key = key(KEY);
    let mut student = marked(LAW);
    "<script> [a](javascript:b) `c`".clone_into(&mut student.milestones[0].label);
    let text = markdown::student(&key, &student);
    let plain = "| &lt;script&gt; \\[a\\](javascript:b) \\`c\\` |";
    assert!(text.contains(plain), "{text}");
    let link = "\\href{javascript:alert(1)}{x}";
    for (source, fenced) in [
        ("a\n```\n<script>", "\n````\na\n```\n<script>\n````\n"),
        ("L_x", "\n```math\nL_x\n```\n"),
        (link, "\n```\n\\href{javascript:alert(1)}{x}\n```\n"),
    ] {
        let text = markdown::student(&key, &of_line(source));
        assert!(text.contains(fenced), "{text}");
    }
}

/// A formula on the page of a student.
fn drawn(source: &str) -> String {
    let page = html::student(&key(KEY), &of_line(source));
    let (_, behind) = page
        .rsplit_once("<div class=\"formula\">")
        .expect("a formula");
    let (drawn, _) = behind.split_once("</div>").expect("its end");
    drawn.to_owned()
}

#[test]
fn a_formula_is_drawn_and_what_cannot_be_is_shown_as_text() {
    assert!(drawn("M_x = I\\dot\\omega_x").contains("<msub>"));
    let shown = drawn("\\href{javascript:alert(1)}{<script>}");
    assert!(
        shown.starts_with("<code>") && !shown.contains("<script>"),
        "{shown}"
    );
    assert!(drawn(&"{".repeat(100)).starts_with("<code>"));
}

#[test]
fn what_is_drawn_is_what_is_written() {
    let matrix = drawn("&A = \\begin{pmatrix} a & b \\\\ c & d \\end{pmatrix}");
    assert_eq!(matrix.matches("<mtd>").count(), 4, "{matrix}");
    let power = drawn("\\theta\\sin^2\\theta");
    assert!(
        power.contains("<msup><mi>sin</mi><mn>2</mn></msup>"),
        "{power}"
    );
    let long = drawn(
        "M_x = I_{xx}\\dot\\omega_x - I_{xz}\\dot\\omega_z + (I_{zz} - I_{yy})\\omega_y\\omega_z",
    );
    assert_eq!(long.matches("<wbr>").count(), 4, "{long}");
    let spaced = drawn("a\\ b\\text{ for }c~d");
    assert!(
        spaced.starts_with("<math") && !spaced.contains("nbsp"),
        "{spaced}"
    );
    assert!(drawn("\\dot L_x").contains("scriptlevel=\"-1\">˙</mo></mover>"));
}
