//! Marking a class against a key: the rules of marking, hostile submissions, and classes of which the truth is known.

#![cfg(feature = "cli")]

mod grade {
    mod class;
    mod command;
    mod effort;
    mod elements;
    mod exercise;
    mod feedback;
    mod hostile;
    mod key;
    mod meanings;
    mod outputs;
    mod period;
    mod platforms;
    mod rules;
    mod runs;
    mod spread;
    mod submissions;
    mod withdrawn;
    mod written;

    use polhode::grade::{Graded, Key, Work, mark};
    use polhode::notation::document::Format;

    /// The key of the example class.
    pub(crate) const KEY: &str = include_str!("../examples/grading/key.md");

    /// The first lines of a good submission: the law, its first component, and the angular momentum.
    pub(crate) const LAW: &str =
        "In rotating axes $$\\vec M = (\\dot{\\vec L})_{xyz} + \\vec\\omega\\times\\vec L.$$\n";
    pub(crate) const COMPONENT: &str =
        "The first component is $$M_x = \\dot L_x + \\omega_y L_z - \\omega_z L_y.$$\n";
    pub(crate) const MOMENTUM: &str = "The momentum is $$L_x = I_{xx}\\omega_x - I_{xz}\\omega_z$$ \
         $$L_y = I_{yy}\\omega_y$$ $$L_z = I_{zz}\\omega_z - I_{xz}\\omega_x$$\n";
    pub(crate) const ANSWER: &str = "So $$M_x = I_{xx}\\dot\\omega_x - I_{xz}(\\dot\\omega_z + \
         \\omega_x\\omega_y) + (I_{zz} - I_{yy})\\omega_y\\omega_z$$\n";

    pub(crate) fn key(text: &str) -> Key {
        Key::read("key.md", text, Format::Markdown).unwrap_or_else(|wrong| {
            let wrong: Vec<String> = wrong.iter().map(ToString::to_string).collect();
            panic!("the key is refused: {}", wrong.join("\n"))
        })
    }

    /// One submission marked by a key.
    pub(crate) fn marked_by(text: &str, submission: &str) -> Graded {
        mark(
            &key(text),
            &Work::of_text("s", "s.md", Format::Markdown, submission),
        )
    }

    /// One submission marked by the key of the example.
    pub(crate) fn marked(submission: &str) -> Graded {
        marked_by(KEY, submission)
    }

    /// The outcomes of the milestones (1), (2), (4), (5).
    pub(crate) fn outcomes(graded: &Graded) -> Vec<&'static str> {
        graded.milestones.iter().map(|m| m.outcome.name()).collect()
    }
}
