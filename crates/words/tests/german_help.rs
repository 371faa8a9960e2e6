//! German help.
#[test]
fn dump() {
    std::fs::write("/tmp/h/wscripts/schema.json", job::job_schema().to_string()).unwrap();
}
