package org.u2sa.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.Ping;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

/** Message signing: who is heard, and that nobody is heard twice. */
@SuppressWarnings("deprecation") // Ping: any message would do
class MavlinkSigningTest {
  private static final long NOW_MICROS = 1_800_000_000_000_000L;

  private final AtomicLong clock = new AtomicLong(NOW_MICROS);
  private final MavlinkStream vehicle = stream(1, "secret", clock);

  private static MavlinkStream stream(int system, String passphrase, AtomicLong clock) {
    return new MavlinkStream(system, 1, Optional.of(new MavlinkSigning(passphrase, clock::get)));
  }

  private static byte[] ping(MavlinkStream from) {
    return from.encode(
        Ping.builder().timeUsec(BigInteger.ONE).seq(7).targetSystem(0).targetComponent(0).build());
  }

  private List<Object> heard(byte[] packet) {
    List<Object> heard = new ArrayList<>();
    vehicle.accept(packet, packet.length, received -> heard.add(received.payload()));
    return heard;
  }

  @Test
  void accept_signedWithTheKey_isHeard() {
    MavlinkStream station = stream(255, "secret", clock);
    assertThat(heard(ping(station))).hasSize(1);
    assertThat(heard(ping(station))).hasSize(1);
  }

  @Test
  void accept_samePacketAgain_isRefused() {
    byte[] packet = ping(stream(255, "secret", clock));
    assertThat(heard(packet)).hasSize(1);
    assertThat(heard(packet)).isEmpty();
    assertThat(vehicle.lastRefusal()).isEqualTo("Ping: outdated signature");
  }

  @Test
  void accept_otherKeyOrUnsigned_isRefused() {
    assertThat(heard(ping(stream(255, "guess", clock)))).isEmpty();
    assertThat(vehicle.lastRefusal()).isEqualTo("Ping: wrong signature");
    assertThat(heard(ping(new MavlinkStream(255, 1)))).isEmpty();
    assertThat(vehicle.lastRefusal()).isEqualTo("Ping: not signed");
  }

  @Test
  void accept_newStreamOlderThanAMinute_isRefused() {
    byte[] recorded = ping(stream(255, "secret", clock));
    clock.addAndGet(61_000_000);
    assertThat(heard(recorded)).isEmpty();
    assertThat(heard(ping(stream(254, "secret", clock)))).hasSize(1);
  }

  @Test
  void accept_changedAnywhere_isRefused() {
    byte[] packet = ping(stream(255, "secret", clock));
    for (int i = 0; i < packet.length; i++) {
      byte[] changed = packet.clone();
      changed[i] ^= 0x10;
      vehicle.reset();
      assertThat(heard(changed)).as("byte " + i).isEmpty();
    }
  }
}
