package org.u2sa.drivers.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.device.port.TrafficTarget;
import org.u2sa.drivers.link.MemoryLink;

class MavlinkTrafficTest {
  private final MemoryLink link = new MemoryLink();
  private final MavlinkTraffic receiver = new MavlinkTraffic(link);

  private MavlinkTraffic hear(byte[] frame) {
    receiver.read(9_000_000);
    link.fromDevice(frame);
    receiver.read(10_000_000);
    return receiver;
  }

  @Test
  void read_example_hasNameTimeAndKindOfAltitude() {
    TrafficTarget target =
        hear(AdsbFrames.example()).read(10_000_000).orElseThrow().targets().get(0);
    assertThat(target.name()).isEqualTo("N825V");
    assertThat(target.isPressureAltitude()).isTrue();
    assertThat(target.heardAtMicros()).as("2 s since it was heard").isEqualTo(8_000_000);
  }

  @Test
  void read_flagsUnset_leaveOutWhatIsNotValid() {
    TrafficTarget target =
        hear(AdsbFrames.frame(1, 449_070_800).from(1))
            .read(10_000_000)
            .orElseThrow()
            .targets()
            .get(0);
    assertThat(target.name()).isEmpty();
    assertThat(target.altitudeM()).isEmpty();
    assertThat(target.velocity()).isEmpty();
  }

  @Test
  void read_withoutValidPlace_isAliveButNoTarget() {
    assertThat(
            hear(AdsbFrames.frame(2, 449_070_800).from(1)).read(10_000_000).orElseThrow().targets())
        .isEmpty();
  }

  @Test
  void read_placeNotOnEarth_isRefused() {
    MavlinkTraffic receiver = hear(AdsbFrames.frame(1, 950_000_000).from(1));
    assertThat(receiver.malformed()).isEqualTo(1);
    assertThat(receiver.lastRefusal()).startsWith("ADSB_VEHICLE at latitude 95.0000000,");
  }
}
