package org.u2sa.drivers.rc;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.device.port.RadioReceiver;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.testkit.DeviceContract;

/** Receivers that report all sticks at their centres. */
class RadioReceiverPortTest extends DeviceContract<RadioReceiver.Pulses> {
  /** All channels 992, as ExpressLRS receivers send it. */
  private static final byte[] CENTRED =
      HexFormat.of().parseHex("c81816e0031ff8c0073ef0810f7ce0031ff8c0073ef0810f7cad");

  @Override
  protected List<Bench<RadioReceiver.Pulses>> benches() {
    MemoryLink wire = new MemoryLink();
    return List.of(
        new LinkedBench<>(
            "CRSF", wire, new CrsfReceiver(wire), 20_000, line -> line.fromDevice(CENTRED)));
  }

  @Override
  protected void judge(RadioReceiver.Pulses pulses) {
    assertThat(pulses.widthsS()).hasSize(16);
    assertThat(pulses.widthsS())
        .allSatisfy(width -> assertThat(width).isCloseTo(1.5e-3, within(1e-6)));
  }

  @Test
  void read_wrongChecksumAndOtherFrames_areNoChannels() {
    MemoryLink wire = new MemoryLink();
    CrsfReceiver receiver = new CrsfReceiver(wire);
    byte[] broken = CENTRED.clone();
    broken[7] ^= 4;
    byte[] statistics = HexFormat.of().parseHex("c80c14000000000000000000000000");
    statistics[13] = (byte) CrsfReceiver.crc(statistics, 2, 13);
    wire.fromDevice(broken);
    wire.fromDevice(Arrays.copyOf(statistics, 14));

    assertThat(receiver.read(1_000)).isEmpty();
    assertThat(receiver.malformed()).isPositive();
    assertThat(receiver.lastRefusal()).contains("wrong checksum");
    wire.fromDevice(CENTRED);
    assertThat(receiver.read(2_000)).isPresent();
  }
}
