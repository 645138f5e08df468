package org.u2sa.drivers.traffic;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.device.port.TrafficReceiver;
import org.u2sa.device.port.TrafficTarget;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.messages.frame.Point;

/** Sentences that the documentation and tests of gpsd, pyais and direwolf publish. */
class AisReceiverTest {
  private static final String CLASS_A = "!AIVDM,1,1,,A,15RTgt0PAso;90TKcjM8h6g208CQ,0*4A";
  private static final String MOORED = "!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5C";
  private static final String CLASS_B = "!AIVDM,1,1,,A,B5NJ;PP005l4ot5Isbl03wsUkP06,0*76";
  private static final double KNOT_MPS = 1852.0 / 3600.0;

  private final MemoryLink link = new MemoryLink();
  private final AisReceiver receiver = new AisReceiver(link);

  private TrafficReceiver.Traffic hear(String... sentences) {
    link.fromDevice((String.join("\r\n", sentences) + "\r\n").getBytes(US_ASCII));
    return receiver.read(1_000_000L).orElseThrow();
  }

  private static void assertPlace(TrafficTarget target, double latitude, double longitude) {
    assertThat(target.latitudeDeg()).isCloseTo(latitude, within(1e-6));
    assertThat(target.longitudeDeg()).isCloseTo(longitude, within(1e-6));
  }

  @Test
  void read_classAUnderWay_hasPlaceAndVelocity() {
    TrafficTarget target = hear(CLASS_A).targets().get(0);

    assertThat(target.id()).isEqualTo("371798000");
    assertThat(target.kind()).isEqualTo("vessel");
    assertPlace(target, 48.38163333, -123.39538333);
    Point velocity = target.velocity().orElseThrow();
    assertThat(velocity.distance()).isCloseTo(12.3 * KNOT_MPS, within(1e-9));
    assertThat(Math.toDegrees(Math.atan2(velocity.x(), velocity.y())))
        .isCloseTo(224.0 - 360.0, within(1e-9));
  }

  @Test
  void read_moored_standsStill() {
    TrafficTarget target = hear(MOORED).targets().get(0);

    assertThat(target.id()).isEqualTo("477553000");
    assertPlace(target, 47.58283333, -122.34583333);
    assertThat(target.velocity().orElseThrow().distance()).isZero();
  }

  @Test
  void read_classB_hasPlaceWithoutAccuracy() {
    TrafficTarget target = hear(CLASS_B).targets().get(0);

    assertThat(target.id()).isEqualTo("367430530");
    assertPlace(target, 37.785035, -122.26732);
    assertThat(target.horizontalSigmaM()).isEmpty();
  }

  @Test
  void read_severalVessels_keepsEach() {
    assertThat(hear(CLASS_A, MOORED, CLASS_B).targets()).hasSize(3);
  }

  @Test
  void read_otherAndBrokenMessages_areNoVessels() {
    TrafficReceiver.Traffic traffic =
        hear(
            "!AIVDM,1,1,,A,403OtVAv>lba;o?Ia`E`4G?02H6k,0*47", // base station
            "!AIVDM,2,1,9,B,53nFBv01SJ<thHp6220H4heHTf2222222222221?50:454o<`9QSlUDp,0*09",
            CLASS_B.replace("B5NJ", "B5NK")); // wrong checksum

    assertThat(traffic.targets()).isEmpty();
  }
}
