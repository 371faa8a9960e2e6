use report::Language;
#[test]
fn left() {
    let Ok(all) = std::fs::read_to_string("/tmp/texts.tsv") else { return };
    let mut out = String::new();
    for line in all.lines() {
        let (page, text) = line.split_once('\t').unwrap();
        for left in Language::German.leaves(text) {
            out += &format!("{page}\t{left}\t{}\n", if left == text { "" } else { text });
        }
    }
    std::fs::write("/tmp/left.tsv", out).unwrap();
    let mut said = String::new();
    for line in all.lines() {
        let (_, text) = line.split_once('\t').unwrap();
        let german = Language::German.say(text);
        if german != text {
            said += &format!("{text}\n    {german}\n");
        }
    }
    std::fs::write("/tmp/said.txt", said).unwrap();
}
