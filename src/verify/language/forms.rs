//! How words are inflected, and the short form in which the lexicon writes several.

use std::borrow::Cow;

/// The forms between bars, with all that those with brackets stand for.
pub(crate) fn forms_of(forms: &'static str) -> Vec<Cow<'static, str>> {
    match forms.contains('(') {
        true => parted(forms).into_iter().flat_map(alternatives).collect(),
        false => forms.split('|').map(Cow::Borrowed).collect(),
    }
}

/// The forms between bars; bars between brackets do not part.
fn parted(forms: &'static str) -> Vec<&'static str> {
    let mut inside = false;
    forms
        .split(move |c| {
            inside = (inside || c == '(') && c != ')';
            c == '|' && !inside
        })
        .collect()
}

/// The forms that `cent(re|er)` stands for.
fn alternatives(form: &'static str) -> Vec<Cow<'static, str>> {
    let Some((before, rest)) = form.split_once('(') else {
        return vec![form.into()];
    };
    let Some((inside, after)) = rest.split_once(')') else {
        return vec![];
    };
    let rests = alternatives(after);
    let one = |a: &str| -> Vec<Cow<'static, str>> {
        let whole = |rest: &Cow<'static, str>| [before, a, rest].concat().into();
        rests.iter().map(whole).collect()
    };
    inside.split('|').flat_map(one).collect()
}

/// The first of several words.
pub(crate) fn first_word(text: &str) -> &str {
    let end = text.bytes().position(|b| b == b' ');
    end.map_or(text, |end| &text[..end])
}

/// A form and its irregular inflection, if it has one.
pub(crate) fn with_irregular(form: &str) -> (&str, Option<&str>) {
    let mut parts = form.split(',').map(str::trim);
    (parts.next().unwrap_or_default(), parts.next())
}

/// The words of a form in lower case, with one space between them.
pub(crate) fn in_lower_case(form: Cow<'static, str>) -> Cow<'static, str> {
    let mut before = b' ';
    let is_plain = |b: u8| match std::mem::replace(&mut before, b) {
        b' ' if b == b' ' => false,
        _ => b == b' ' || b.is_ascii_graphic() && !b.is_ascii_uppercase(),
    };
    if form.bytes().all(is_plain) {
        return form;
    }
    let words: Vec<String> = form.split_whitespace().map(str::to_lowercase).collect();
    Cow::Owned(words.join(" "))
}

/// The plural of a noun: the ending is on the word before "of" or on the last one.
pub(crate) fn in_plural(noun: &str) -> String {
    const STOPS: [&str; 5] = [" of ", " in ", " to ", " without ", " about "];
    let mut spaces = noun.char_indices().filter(|(_, c)| *c == ' ');
    let end = spaces.find(|(at, _)| STOPS.iter().any(|stop| noun[*at..].starts_with(stop)));
    let (head, rest) = noun.split_at(end.map_or(noun.len(), |(at, _)| at));
    with_s(head) + rest
}

/// A verb whose first word takes an ending.
pub(crate) fn on_first(verb: &str, ending: fn(&str) -> String) -> String {
    match verb.split_once(' ') {
        Some((first, rest)) => ending(first) + " " + rest,
        None => ending(verb),
    }
}

pub(crate) fn with_s(word: &str) -> String {
    let hissing = ["s", "x", "z", "ch", "sh"];
    match word.strip_suffix('y') {
        _ if word == "have" => "has".into(),
        Some(stem) if !stem.ends_with(['a', 'e', 'o', 'u']) => [stem, "ies"].concat(),
        _ if hissing.iter().any(|h| word.ends_with(h)) => [word, "es"].concat(),
        _ => [word, "s"].concat(),
    }
}

pub(crate) fn with_ed(word: &str) -> String {
    match word.strip_suffix('e') {
        Some(stem) => [stem, "ed"].concat(),
        None => [word, "ed"].concat(),
    }
}
