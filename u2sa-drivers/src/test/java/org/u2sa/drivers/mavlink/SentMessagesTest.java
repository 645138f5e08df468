package org.u2sa.drivers.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.u2sa.drivers.motor.PulseWidth;
import org.u2sa.mavlink.MavlinkStream;

/** What goes to an autopilot, compared with bytes of pymavlink 2.4.50. */
class SentMessagesTest {
  private static byte[] hex(String text) {
    byte[] bytes = new BigInteger("01" + text, 16).toByteArray();
    return Arrays.copyOfRange(bytes, 1, bytes.length);
  }

  private static Map<String, OptionalDouble> percentages(Object... namesAndPercents) {
    Map<String, OptionalDouble> map = new HashMap<>();
    for (int i = 0; i < namesAndPercents.length; i += 2) {
      map.put((String) namesAndPercents[i], OptionalDouble.of((Double) namesAndPercents[i + 1]));
    }
    return map;
  }

  private static byte[] sent(CommandForm form, Object... namesAndPercents) {
    Map<String, OptionalDouble> map = percentages(namesAndPercents);
    return new MavlinkStream(255, 191)
        .encode(
            form.message(
                new CommandForm.Target(1, 1),
                name -> map.getOrDefault(name, OptionalDouble.empty()),
                0));
  }

  @Test
  void encode_rcOverride_isPymavlinks() {
    RcOverride form =
        new RcOverride(
            List.of(
                new RcOverride.Channel(1, "STEERING", false),
                new RcOverride.Channel(3, "THROTTLE", false)),
            PulseWidth.STANDARD);
    assertThat(sent(form, "STEERING", 50.0))
        .isEqualTo(hex("fd12000000ffbf460000d606ffffdc05ffffffffffffffffffff010193c8"));
  }

  @Test
  void encode_velocity_isPymavlinks() {
    VelocityTarget form = new VelocityTarget(5.0, 2.0, 1.0);
    byte[] expected =
        hex(
            "fd35000000ffbf5400000000000000000000000000000000000000002040000080bf000000bf"
                + "000000000000000000000000000000000000803ec705010108ade0");
    assertThat(
            sent(
                form,
                VelocityTarget.FORWARD,
                50.0,
                VelocityTarget.LEFT,
                20.0,
                VelocityTarget.CLIMB,
                25.0,
                VelocityTarget.TURN,
                -25.0))
        .isEqualTo(expected);
  }

  @Test
  void encode_heartbeatAndRequest_arePymavlinks() {
    List<byte[]> sent = new ArrayList<>();
    AutopilotPeer peer =
        new AutopilotPeer(
            1, 10.0, message -> sent.add(new MavlinkStream(255, 191).encode(message)));
    peer.step(true, 10_000_000);
    assertThat(sent.get(0)).isEqualTo(hex("fd09000000ffbf000000000000001208000403cb64"));
    assertThat(sent.get(1))
        .isEqualTo(
            hex(
                "fd20000000ffbf4c00000000f0410050c347000000000000000000000000000000000000"
                    + "0000ff010101edb6"));
    assertThat(sent).hasSize(6);
  }
}
