package org.u2sa.drivers.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.Size;

/** Against a queue that is as simple as can be. */
class ByteRingProperties {
  private static final int CAPACITY = 7;

  @Property(tries = 500)
  void putAndTake_anySizes_newestAreKeptInOrder(
      @ForAll @Size(max = 20) List<@Size(max = 12) List<Byte>> puts,
      @ForAll @Size(max = 20) List<Boolean> takes) {
    ByteRing ring = new ByteRing(CAPACITY);
    Deque<Byte> model = new ArrayDeque<>();
    byte value = 0;
    for (int turn = 0; turn < puts.size(); turn++) {
      byte[] bytes = new byte[puts.get(turn).size()];
      for (int i = 0; i < bytes.length; i++) {
        bytes[i] = ++value;
        model.add(bytes[i]);
      }
      int dropped = 0;
      while (model.size() > CAPACITY) {
        model.remove();
        dropped++;
      }
      assertThat(ring.put(bytes, bytes.length)).isEqualTo(dropped);
      if (turn < takes.size() && takes.get(turn)) {
        byte[] taken = new byte[3];
        int count = ring.take(taken);
        assertThat(count).isEqualTo(Math.min(3, model.size()));
        for (int i = 0; i < count; i++) {
          assertThat(taken[i]).isEqualTo(model.remove());
        }
      }
    }
    byte[] rest = new byte[CAPACITY];
    assertThat(ring.take(rest)).isEqualTo(model.size());
    for (int i = 0; !model.isEmpty(); i++) {
      assertThat(rest[i]).isEqualTo(model.remove());
    }
  }
}
