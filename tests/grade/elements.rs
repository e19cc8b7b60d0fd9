//! What a drawn formula may hold, decided by going through it once or by a parser: both find the same.

#[path = "../../src/report/html/elements.rs"]
mod of_formulas;

use of_formulas::{Part, harmless_parts};
use roxmltree::Document;

#[test]
fn active_content_is_never_let_through() {
    for active in [
        "<math><mi href=\"javascript:a\">x</mi></math>",
        "<math><script>a</script></math>",
        "<math><mi onclick=\"a\">x</mi></math>",
        "<math><mi style=\"background: url(a)\">x</mi></math>",
        "<math><mi width=\"&#117;rl\">x</mi></math>",
    ] {
        assert_eq!(harmless_parts(active), None, "{active}");
    }
    assert!(harmless_parts("<math display=\"block\"><mi>x</mi></math>").is_some());
}

#[test]
fn what_no_parser_reads_and_no_browser_draws_as_meant_is_refused() {
    for odd in [
        "<math><mi>x</mi></math><math></math>",
        "<math><mi>x</math></mi>",
        "<math><msub><mi>x</mi></msub></math>",
        "<math><mi mathvariant=\"a\" mathvariant=\"b\">x</mi></math>",
        "<math><mi width=\"<1\">x</mi></math>",
        "<math><mi>&nbsp;</mi></math>",
        "<math><mi>x</mi>",
        "<math><mi>a]]>b</mi></math>",
    ] {
        assert_eq!(harmless_parts(odd), None, "{odd}");
    }
}

#[test]
fn the_parts_are_those_that_a_parser_finds() {
    for drawn in [
        "<math display=\"block\"><mi>x</mi><mo>=</mo><msub><mi>I</mi><mn>2</mn></msub></math>",
        "<math><mo stretchy=\"false\" form=\"prefix\">(</mo><mspace width=\"1em\" /><mrow></mrow></math>",
        "<math>x<mi>x</mi></math>",
        "<math><!-- a --><mi>x</mi></math>",
    ] {
        let tree = Document::parse(drawn).expect("a tree");
        let parts = tree.root_element().children().map(|part| Part {
            range: part.range(),
            operator: (part.text().filter(|_| part.has_tag_name("mo"))).map(str::to_owned),
        });
        let parts: Vec<_> = parts.collect();
        assert_eq!(harmless_parts(drawn), Some(parts), "{drawn}");
    }
}
