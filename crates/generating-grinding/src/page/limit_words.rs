//! Limits of the shop in words.

/// What a key of `technology.limits` bounds, in words.
pub(super) fn limit_in_words(key: &str) -> String {
    let key = key.rsplit('.').next().unwrap_or(key);
    match key {
        "Qw_roughing" => "removal rate Q'_w, roughing".to_owned(),
        "Qw_finishing" => "removal rate Q'_w, finishing".to_owned(),
        "Vw_roughing" => "removed volume V'_w, roughing".to_owned(),
        "Vw_finishing" => "removed volume V'_w, finishing".to_owned(),
        "feed_mark_um" => "height of feed marks".to_owned(),
        "largest_feed" => "largest feed".to_owned(),
        "least_feed" => "least feed".to_owned(),
        "zone_width" => "width of a zone".to_owned(),
        "wheel_speed_m_per_s" => "speed of the wheel, m/s".to_owned(),
        "worm_speed_rpm" => "speed of the worm, 1/min".to_owned(),
        "work_speed_rpm" => "speed of the workpiece, 1/min".to_owned(),
        "contact_length_mm" => "contact length".to_owned(),
        other => other.replace('_', " "),
    }
}

#[cfg(test)]
mod tests {
    use super::limit_in_words;

    #[test]
    fn limits_have_words() {
        assert_eq!(limit_in_words("technology.limits.Qw_roughing"), "removal rate Q'_w, roughing");
        assert_eq!(limit_in_words("technology.limits.some_other_key"), "some other key");
    }
}
