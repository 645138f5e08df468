package org.u2sa.sim.ioio;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;

/** Whatever a host sends, the board goes on or hangs up, and then nothing is driven. */
class IoioFirmwareProperties {
  private static final int LED = 0;

  @Property(tries = 500)
  void accept_anyBytes_boardGoesOnOrHangsUp(
      @ForAll @Size(max = 300) byte[] bytes, @ForAll @IntRange(min = 1, max = 40) int chunk) {
    Bench bench = new Bench().open();
    bench.send(3, 10 << 2).send(8, 10, 0x80).send(0x0A, 0x81, 0x3F, 0x9C).send(9, 0, 9, 9);
    for (int at = 0; at < bytes.length; at += chunk) {
      bench.firmware.accept(bytes, at, Math.min(chunk, bytes.length - at));
      bench.advance(0.002);
    }
    if (!bench.firmware.isOpen()) {
      assertThat(bench.driven).isEmpty();
      assertThat(bench.levels).containsOnlyKeys(LED);
      assertThat(bench.answer()).isEmpty();
      assertThat(bench.firmware.trouble()).isNotEmpty();
    }
    bench.firmware.open();
    assertThat(bench.answer()).startsWith("00 49 4f 49 4f");
    assertThat(bench.driven).isEmpty();
  }

  /** Only types that the board knows, so that sessions become long; arguments of any kind. */
  @Property(tries = 500)
  void accept_knownTypesWithAnyArguments_neverThrows(
      @ForAll @Size(max = 60) byte[] types, @ForAll @Size(min = 12, max = 12) byte[] arguments) {
    Bench bench = new Bench().open();
    for (byte octet : types) {
      int type = Math.floorMod(octet, Message.SYNC + 1);
      int length = Message.argumentLength(type);
      if (length < 0 || type == Message.HARD_RESET) {
        continue;
      }
      bench.send(type);
      bench.firmware.accept(arguments, 0, length);
      bench.advance(0.001);
      bench.answer();
    }
    bench.firmware.lost();
    assertThat(bench.driven).isEmpty();
  }
}
