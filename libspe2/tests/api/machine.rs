//! The machine that a program sees.

use spe2::cpu_info::spe_cpu_info_get;

use crate::support::assert_fails;

#[test]
fn machine_is_playstation_3() {
    unsafe {
        assert_eq!(spe_cpu_info_get(1, -1), 1);
        assert_fails(spe_cpu_info_get(1, 0), libc::EINVAL);
        for request in [2, 3] {
            assert_eq!(spe_cpu_info_get(request, -1), 6);
            assert_eq!(spe_cpu_info_get(request, 0), 6);
            assert_fails(spe_cpu_info_get(request, 1), libc::EINVAL);
            assert_fails(spe_cpu_info_get(request, -2), libc::EINVAL);
        }
        assert_eq!(spe_cpu_info_get(4, 99), 1);
        assert_fails(spe_cpu_info_get(0, -1), libc::EINVAL);
        assert_fails(spe_cpu_info_get(5, -1), libc::EINVAL);
    }
}
