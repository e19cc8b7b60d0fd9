//! The sentences of the language of declarations: what they say, how they are printed, what is wrong with others.

use polhode::notation::Macros;
use polhode::verify::language::statement::{
    Declaration, DeclaredRole, Extent, Misread, NotationMeaning, Sign, Slot, Statement, Term,
};
use polhode::verify::language::{
    Lexicon, idle_rules, manual, read_declarations, read_sentence, sentence,
};
use std::time::{Duration, Instant};

/// Sentences of every family, one a line.
const SENTENCES: &str = include_str!("language/sentences.txt");

fn read(sentence: &str) -> Result<Vec<Declaration>, Misread> {
    read_sentence(sentence, 1, &Macros::default(), &Lexicon::default())
}

fn statement(sentence: &str) -> Statement {
    read(sentence)
        .expect("a sentence of the language")
        .remove(0)
        .statement
}

/// A number as letters.
fn letters(number: u32) -> String {
    let digits = number.to_string();
    digits
        .chars()
        .map(|c| char::from(b'a' + c as u8 - b'0'))
        .collect()
}

fn name(name: &str) -> Term {
    Term::Name(name.into())
}

#[test]
fn every_family_is_read() {
    let (declarations, misread) =
        read_declarations(SENTENCES, &Macros::default(), &Lexicon::default());
    assert!(misread.is_empty(), "{misread:#?}");
    assert!(declarations.len() >= 90);
}

#[test]
fn what_is_printed_reads_back_as_the_same() {
    let lexicon = Lexicon::default();
    let read = |text: &str| read_declarations(text, &Macros::default(), &lexicon);
    let (declarations, _) = read(SENTENCES);
    // a body that the text introduces is known in the text alone
    let printed: Vec<String> = declarations.iter().map(|d| sentence(d, &lexicon)).collect();
    let (back, misread) = read(&printed.join("\n"));
    assert!(misread.is_empty(), "{misread:#?}");
    assert_eq!(back.len(), declarations.len(), "one sentence, one thing");
    for ((declaration, back), printed) in declarations.iter().zip(&back).zip(printed) {
        assert_eq!(back.statement, declaration.statement, "{printed}");
        assert_eq!(back.extent, declaration.extent, "{printed}");
        assert_eq!(sentence(back, &lexicon), printed);
    }
}

#[test]
fn slots_hold_what_the_words_say() {
    let Statement::Is { subjects, what } = statement(
        "`$h$` is the moment of momentum of the rotor about Q with respect to E."
            .replace('`', "")
            .as_str(),
    ) else {
        panic!("not read as a noun of a letter");
    };
    assert_eq!(subjects.len(), 1);
    assert_eq!(what.head, "angular momentum");
    assert_eq!(what.slot(Slot::Of), Some(&name("rotor")));
    assert_eq!(what.slot(Slot::About), Some(&name("Q")));
    assert_eq!(what.slot(Slot::RelativeTo), Some(&name("E")));

    let Statement::Does { verb, slots, .. } = statement(
        "D revolves about the axis through Q along $e$ at the constant rate $p$ relative to E.",
    ) else {
        panic!("not read as a verb");
    };
    assert_eq!(verb, "turn");
    let kinds: Vec<Slot> = slots.iter().map(|(slot, _)| *slot).collect();
    assert_eq!(kinds, [Slot::About, Slot::At, Slot::RelativeTo]);
}

#[test]
fn one_sentence_may_say_several_things() {
    let said = read("Lines 2, 5 and 7 to 9 are assumed.").expect("read");
    assert_eq!(said.len(), 3);
    assert!(said.iter().all(|d| matches!(
        d.statement,
        Statement::Role {
            role: DeclaredRole::Assume,
            ..
        }
    )));
    let said = read("$P, Q, S$ are the components of $w$ on D.").expect("read");
    assert!(matches!(&said[0].statement, Statement::Is { subjects, .. } if subjects.len() == 3));
}

/// What sentences are printed as that say several things in one.
#[test]
fn clauses_appositions_and_gaps_are_sentences_of_their_own() {
    let printed = |text: &str| {
        let said = read(text).expect("read");
        let each = said.iter().map(|d| sentence(d, &Lexicon::default()));
        each.collect::<Vec<_>>()
    };
    let pairs = [
        (
            "D is an inertial frame, and $z$ is the upward vertical.",
            ["D is an inertial frame.", "$z$ is the upward vertical."],
        ),
        (
            "$m$ is the mass of the ship and $g$ the acceleration of gravity.",
            [
                "$m$ is the mass of the ship.",
                "$g$ is the acceleration of gravity.",
            ],
        ),
        (
            "O is the pivot, a point fixed in D.",
            ["O is the pivot.", "O is a point fixed in D."],
        ),
        (
            "Line 9 defines $p$ and $q$.",
            ["Line 9 defines $p$.", "Line 9 defines $q$."],
        ),
    ];
    for (text, expected) in pairs {
        assert_eq!(printed(text), expected);
    }
    let single = [
        (
            "The frame K is fixed in the ship.",
            "K is a frame fixed in the ship.",
        ),
        (
            "The only loads on the ship are the weight and the force at O.",
            "The weight and the force at O are the only loads on the ship.",
        ),
        (
            "D is an inertial frame with the axes $i$, $j$, $k$.",
            "D is an inertial frame with axes $i$, $j$ and $k$.",
        ),
        (
            "A dot means the rate entry by entry.",
            "A dot is entry by entry.",
        ),
    ];
    for (text, expected) in single {
        assert_eq!(printed(text), [expected]);
    }
}

#[test]
fn marks_have_rules() {
    let Statement::Notation { sign, meaning } = statement("An overdot means the rate seen from D.")
    else {
        panic!("not read as a rule");
    };
    assert_eq!(sign, Sign::Mark("dot"));
    assert!(
        matches!(meaning, NotationMeaning::Noun(phrase) if phrase.slot(Slot::SeenFrom) == Some(&name("D")))
    );
}

#[test]
fn extents_narrow_each_other() {
    let said = read("In cell 4, lines 2 to 6, E is an inertial frame.").expect("read");
    let lines = Extent::Lines {
        cell: Some(4),
        first: 2,
        last: Some(6),
    };
    assert_eq!(said[0].extent, lines);
    let said =
        read("In the section \"Wheels\" on line 8 the second $s$ is constant.").expect("read");
    assert!(matches!(&said[0].extent, Extent::Both(..)));
}

#[test]
fn plain_formulas_are_words() {
    let said = read("`Fx` is the force on the rotor along `i`.").expect("read");
    let Statement::Is { subjects, .. } = &said[0].statement else {
        panic!("not read as a noun of a letter");
    };
    let Term::Formula(formula) = &subjects[0] else {
        panic!("not a formula");
    };
    assert!(
        format!("{:?}", formula.row).contains("Symbol"),
        "one symbol, no product"
    );
}

#[test]
fn errors_name_the_place_and_the_word() {
    let cases = [
        (
            "$s$ is the spinn of the rotor.",
            12,
            "`spinn` is no noun here",
            "did you mean `spin`?",
        ),
        (
            "D is a frmae fixed in the rotor.",
            8,
            "`frmae` is no noun here",
            "did you mean `frame`?",
        ),
        (
            "D trns relative to E.",
            3,
            "`trns` is no verb here",
            "did you mean `turns`?",
        ),
        ("$s$ is the mass of", 19, "the sentence ends too early", ""),
        ("$s is the mass.", 1, "the formula is not closed", ""),
        (
            "Line 5 is nice.",
            11,
            "`nice` is no role of a line here",
            "",
        ),
        (
            "E is an inertial frame about.",
            29,
            "the sentence ends too early",
            "",
        ),
    ];
    for (sentence, column, message, help) in cases {
        let error = read(sentence).expect_err(sentence);
        assert_eq!((error.line, error.column), (1, column), "{error}");
        assert_eq!(error.message, message);
        assert!(
            error.help.as_deref().unwrap_or_default().contains(help),
            "{error}"
        );
    }
    let (_, misread) = read_declarations(
        "# a remark\n\nE is.\n",
        &Macros::default(),
        &Lexicon::default(),
    );
    assert_eq!(misread[0].line, 3);
}

#[test]
fn a_new_noun_may_be_introduced() {
    let text = "The pod is a rigid body of mass $m$.\n$G$ is the mass centre of the pod.";
    let (said, misread) = read_declarations(text, &Macros::default(), &Lexicon::default());
    assert_eq!((said.len(), misread.len()), (2, 0), "{misread:?}");
}

#[test]
fn a_body_must_be_introduced_and_no_slip() {
    let read = |text: &str| read_declarations(text, &Macros::default(), &Lexicon::default());
    let said = [
        "The kite turns relative to E.",
        "P is fixed in the left ski.",
        "The mass of kite 2 is $m$.",
        "D is a frame fixed in the mount.",
        "The movable pulley is massless.",
        "The kite exerts the force $F$ on the rod at A.",
    ];
    for sentence in said {
        assert!(read(sentence).1.is_empty(), "{sentence}");
    }
    let slips = [
        (
            "D is a frame fixed in the spacecarft.",
            "did you mean `spacecraft`?",
        ),
        (
            "$m$ is the mass of the platfrom.",
            "did you mean `platform`?",
        ),
        ("$h$ is the height of the kite above Q.", ""),
        ("The kite is hardly a rigid body.", ""),
    ];
    for (sentence, help) in slips {
        let (_, misread) = read(sentence);
        assert_eq!(misread.len(), 1, "{sentence}");
        assert!(
            misread[0]
                .help
                .as_deref()
                .unwrap_or_default()
                .contains(help),
            "{sentence}"
        );
    }
    let (_, misread) = read("D is a frame fixed in the motro.\n$m$ is the mass of the motro.");
    assert!(misread.is_empty(), "said twice it is no slip: {misread:?}");
}

#[test]
fn a_condition_is_kept() {
    let at = |slots: &[(Slot, Term)]| slots.iter().any(|(slot, _)| *slot == Slot::At);
    for sentence in [
        "$u = v$ at $t = 0$.",
        "At $t = 0$, $u = v$.",
        "$u$ is $v$ when $t = 0$.",
    ] {
        let Statement::Does {
            subjects,
            verb,
            slots,
        } = statement(sentence)
        else {
            panic!("{sentence}: not under a condition");
        };
        assert_eq!((verb, at(&slots)), ("hold", true), "{sentence}");
        let [Term::Formula(formula)] = subjects.as_slice() else {
            panic!("{sentence}: no formula");
        };
        assert_eq!(formula.source, "u = v");
    }
    assert!(matches!(statement("$u$ is $v$."), Statement::Same { .. }));
}

#[test]
fn what_is_not_so_is_never_read_as_so() {
    for sentence in [
        "The hoop does not roll on the floor.",
        "D is not fixed in the rotor.",
        "No rotor turns.",
        "$u = v$ unless $t = 0$.",
        "$u$ is hardly $v$.",
        "G lies below.",
        "$u$ and $v$ are $a$, $b$ and $c$.",
        "$u$ and $v$ are the mass, the radius and the height of the rotor.",
        "Everything is nice.",
    ] {
        assert!(read(sentence).is_err(), "{sentence}");
    }
    let Statement::Does { verb, .. } = statement("The hoop does not turn relative to E.") else {
        panic!("not read as a verb");
    };
    assert_eq!(verb, "keep its direction");
}

#[test]
fn hostile_texts_end_quickly() {
    let start = Instant::now();
    let lexicon = Lexicon::default();
    let texts = [
        "the ".repeat(2_000),
        "$a$ is the mass of ".to_owned() + &"the magnitude of ".repeat(500) + "$b$.",
        "a and ".repeat(60_000),
        "(".repeat(9_000),
        "$".repeat(9_001),
        "The platform consists of ".to_owned()
            + &"a and ".repeat(190)
            + "b as particles at their mass centres.",
        "The platform consists of ".to_owned()
            + &"a and b as particles at the mass centre of ".repeat(11)
            + "c.",
        "On lines 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, ".repeat(12) + "a is b.",
        "the magnitude of the weight of the hub and ".repeat(40) + "a is b.",
        "On line 99999999999999999999999 a is b.".to_owned(),
        "\"".to_owned(),
        "é’′ “ü” is ß.".to_owned(),
        "E is an inertial frmae.\n".repeat(3_000),
        format!("$a$ is the {}.", "x".repeat(5_000)),
        "consists of the ".repeat(180) + "kite.",
        "The system consists of the kite, the ".to_owned() + &"sledge, the ".repeat(190) + "ski.",
        (0..2_000u32)
            .map(|n| format!("D is fixed in the gadge{}t.\n", letters(n)))
            .collect(),
        "$a$ is $b$ at $c$ ".repeat(90) + ".",
        "At $t = 0$, ".repeat(120) + "$a = b$.",
        "$a$ and ".repeat(100) + "$b$ are the " + &"mass, the ".repeat(90) + "radius.",
        "$a$ is the mass of the hub below the hub below ".repeat(15) + "O.",
    ];
    for text in &texts {
        let (_, misread) = read_declarations(text, &Macros::default(), &lexicon);
        assert!(misread.len() <= 3_000);
    }
    for cut in SENTENCES.char_indices().map(|(at, _)| at).step_by(7) {
        let line = SENTENCES[cut..].lines().next().unwrap_or_default();
        let _ = read_sentence(line, 1, &Macros::default(), &lexicon);
    }
    assert!(
        start.elapsed() < Duration::from_secs(60),
        "{:?}",
        start.elapsed()
    );
}

#[test]
fn the_manual_shows_every_noun() {
    let text = manual(&Lexicon::default());
    for word in [
        "angular momentum",
        "moment of momentum",
        "gimbal",
        "without slipping",
        "tilde",
    ] {
        assert!(text.contains(word), "{word}");
    }
}

#[test]
fn clauses_leave_out_what_the_one_before_says() {
    let said = |text: &str| -> Vec<Statement> {
        let declarations = read(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        declarations.into_iter().map(|d| d.statement).collect()
    };
    let same = [
        (
            "The point O is fixed in N, and so is C.",
            "The point O is fixed in N; C is fixed in N.",
        ),
        (
            "$a$ is the rate of $x$ and $b$ that of $y$.",
            "$a$ is the rate of $x$; $b$ is the rate of $y$.",
        ),
        (
            "$a$ and $b$ are the rates of $x$ and $y$.",
            "$a$ is the rate of $x$; $b$ is the rate of $y$.",
        ),
        (
            "By $L$ we mean the angular momentum of the top about O.",
            "$L$ is the angular momentum of the top about O.",
        ),
        ("Let N be an inertial frame.", "N is an inertial frame."),
        (
            "N is an inertial frame, and O is a point fixed in it.",
            "N is an inertial frame; O is a point fixed in N.",
        ),
        (
            "N is an inertial frame, B a frame fixed in the hub and W a frame fixed in the wheel.",
            "N is an inertial frame; B is a frame fixed in the hub; W is a frame fixed in the wheel.",
        ),
        (
            "A dot means the rate seen from N, and a prime the rate seen from B.",
            "A dot means the rate seen from N; a prime means the rate seen from B.",
        ),
        (
            "Relative to B the wheel turns about $n$ at the rate $w$.",
            "The wheel turns about $n$ at the rate $w$ relative to B.",
        ),
        (
            "G is the mass centre of the hub and also of the wheel.",
            "G is the mass centre of the hub; G is the mass centre of the wheel.",
        ),
        (
            "$a$, $b$, $c$ are the components of $u$ on B, $d$, $e$, $f$ those of $v$.",
            "$a$, $b$, $c$ are the components of $u$ on B; $d$, $e$, $f$ are the components of $v$ on B.",
        ),
        (
            "$A$ and $C$ are the moments of inertia of the hub and of the wheel about $n$; $I$ is that of the spacecraft.",
            "$A$ is the moment of inertia of the hub about $n$; $C$ is the moment of inertia of the wheel about $n$; \
             $I$ is the moment of inertia of the spacecraft about $n$.",
        ),
        (
            "The inertial frame N is fixed in the ground.",
            "N is an inertial frame; N is a frame fixed in the ground.",
        ),
        (
            "The ground is an inertial frame N.",
            "N is an inertial frame; the ground is the same as N.",
        ),
        (
            "The axes of B are principal axes of the rotor, and the third of them is $e$.",
            "The axes of B are principal axes of the rotor; $e$ is the third axis of B.",
        ),
        (
            "$n$ is the symmetry axis of the hub and of the wheel.",
            "The hub and the wheel are symmetric about $n$.",
        ),
        (
            "$m$ is the mass of the top and does not change.",
            "$m$ is the mass of the top; $m$ is constant.",
        ),
        (
            "The body is free: no moment acts on it about G.",
            "The body is free; no moment acts on the body about G.",
        ),
        (
            "$L$ on line 3 is the length of the rod.",
            "On line 3 $L$ is the length of the rod.",
        ),
        (
            "O is a point fixed in N and B, and G is the mass centre of the top.",
            "O is a point fixed in N and B; G is the mass centre of the top.",
        ),
        (
            "The craft consists of the hub and the wheel, and B is a frame fixed in it.",
            "The craft consists of the hub and the wheel; B is a frame fixed in the craft.",
        ),
        (
            "$A$ and $C$ are the moments of inertia of the hub about $u$ and $n$, and $D$ and $E$ those of the wheel.",
            "$A$ is the moment of inertia of the hub about $u$; $C$ is the moment of inertia of the hub about $n$; \
             $D$ is the moment of inertia of the wheel about $u$; $E$ is the moment of inertia of the wheel about $n$.",
        ),
        (
            "$w$ is the angular velocity of B relative to A, and $v$ that of A.",
            "$w$ is the angular velocity of B relative to A; $v$ is the angular velocity of A.",
        ),
        (
            "$L$ is the angular momentum of the top about z, which is a unit vector.",
            "$L$ is the angular momentum of the top about z; z is a unit vector.",
        ),
        (
            "$J$ is the inertia tensor of the hub about G, with the entries $J_{jk}$.",
            "$J$ is the inertia tensor of the hub about G; $J_{jk}$ are the entries of $J$.",
        ),
    ];
    for (short, long) in same {
        assert_eq!(said(short), said(long), "{short}");
    }
}

#[test]
fn a_clause_may_have_a_part_of_the_document_of_its_own() {
    let sentence = "$w$ is the rate of $x$ seen from N; on line 3 it is written $v$.";
    let declarations = read(sentence).expect("a sentence of the language");
    let [whole, line] = declarations.as_slice() else {
        panic!("{declarations:?}");
    };
    assert_eq!(whole.extent, Extent::Document);
    let third = Extent::Lines {
        cell: None,
        first: 3,
        last: Some(3),
    };
    assert_eq!(line.extent, third);
}

#[test]
fn what_a_sentence_says_first_is_kept_where_the_rest_is_not_understood() {
    let text =
        "$r$ is the position of P from O, $s$ its gribble.\nP consists of Q, $s$ its gribble.";
    let (declarations, misread) = read_declarations(text, &Macros::default(), &Lexicon::default());
    assert_eq!(misread.len(), 2);
    let read = |d: &&Declaration| !matches!(d.statement, Statement::Unread { .. });
    let mut kept: Vec<usize> = declarations.iter().filter(read).map(|d| d.line).collect();
    kept.dedup();
    assert_eq!(kept, [1], "what goes on may change what is said of things");
}

#[test]
fn what_something_is_stays_so_unless_it_is_taken_back() {
    for (text, wanted) in [
        ("N is an inertial frame, with a gribble.", 1),
        ("A is a frame that follows the gribble of the top.", 1),
        ("N is an inertial frame, but not for a gribble.", 0),
        ("The top turns about $n$, with a gribble.", 0),
    ] {
        let (declarations, misread) =
            read_declarations(text, &Macros::default(), &Lexicon::default());
        let read = |d: &&Declaration| !matches!(d.statement, Statement::Unread { .. });
        assert_eq!(declarations.iter().filter(read).count(), wanted, "{text}");
        assert_eq!(misread.len(), 1, "{text}");
    }
}

#[test]
fn what_may_be_meant_in_two_ways_is_not_read() {
    let text = "$a$ and $b$ are the masses of the hub and the wheel, and $M$ is their mass.";
    let (_, misread) = read_declarations(text, &Macros::default(), &Lexicon::default());
    assert_eq!(misread.len(), 1);
}

#[test]
fn what_is_said_to_follow_says_nothing_new() {
    let text = "The products of inertia are integrals, so the gribbles are their negatives.";
    let (declarations, misread) = read_declarations(text, &Macros::default(), &Lexicon::default());
    assert!(misread.is_empty(), "{misread:?}");
    assert_eq!(declarations.len(), 1, "{declarations:?}");
}

#[test]
fn one_body_has_one_name_and_its_mass_centre_too() {
    let text = "The top is a rigid body.\nNo moment acts on the body about its mass centre G.";
    let (declarations, misread) = read_declarations(text, &Macros::default(), &Lexicon::default());
    assert!(misread.is_empty(), "{misread:?}");
    let said: Vec<String> = declarations
        .iter()
        .map(|d| sentence(d, &Lexicon::default()))
        .collect();
    let wanted = [
        "The top is a rigid body.",
        "No moment acts on the top about G.",
        "G is the mass centre of the top.",
    ];
    assert_eq!(said, wanted);
}

/// The sentences as which one is read.
fn plainly(said: &str) -> Vec<String> {
    let lexicon = Lexicon::default();
    let read = read(said).unwrap_or_else(|misread| panic!("{said}: {misread:?}"));
    read.iter().map(|d| sentence(d, &lexicon)).collect()
}

#[test]
fn other_ways_to_say_a_sentence_are_read_as_the_plain_one() {
    for (said, plain) in [
        (
            "P is a point that lies on z.",
            &["P is a point.", "P lies on z."][..],
        ),
        ("The bar joins A to B.", &["The rod extends from A to B."]),
        (
            "By $L$ we mean the momentum of B.",
            &["$L$ is the momentum of B."],
        ),
        ("$a$ is larger than $b$.", &["$a>b$."]),
    ] {
        assert_eq!(plainly(said), plain, "{said}");
    }
}

#[test]
fn a_list_is_no_part_of_a_formula() {
    for list in [
        "$a$ is larger than $b$ and $c$.",
        "$a$ and $b$ are larger than $c$.",
        "The equality of $a$, $b$ and $c$ is assumed.",
    ] {
        assert!(read(list).is_err(), "{list}");
    }
}

#[test]
fn each_rule_changes_its_example() {
    assert_eq!(idle_rules(), [""; 0]);
}
