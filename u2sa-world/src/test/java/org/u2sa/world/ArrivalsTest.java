package org.u2sa.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** What waits, and what is dropped when too much does. */
class ArrivalsTest {
  private final Arrivals arrivals = new Arrivals();

  private static U2SAData scan(long micros, int beams) throws MalformedMessageException {
    RangeScan scan =
        new RangeScan()
            .sensorName("Lidar")
            .maxRange(10.0)
            .beams(0.0, 1.0e-5, Collections.nCopies(beams, OptionalDouble.of(1.0)));
    scan.timestamp(micros);
    return new MessageCodec(StandardTypes.registry()).decode(scan.typeChain(), scan.serialize());
  }

  @Test
  void add_longScansOfOthers_someMegabytesWaitAndTheNewestAreAmongThem()
      throws MalformedMessageException {
    long most = Math.max(4L << 20, Runtime.getRuntime().maxMemory() / 32);
    long each = scan(0L, 50_000).receivedBytes();
    int sent = (int) (most / each) + 3;
    for (int i = 0; i < sent; i++) {
      arrivals.add(scan(i, 50_000));
    }

    assertThat(arrivals.lost()).isBetween(3L, 4L);
    List<U2SAData> due = arrivals.upTo(sent);
    assertThat(due.size() + arrivals.lost()).isEqualTo(sent);
    assertThat(due.get(due.size() - 1).timestamp()).hasValue(sent - 1);
    for (int i = 0; i < due.size(); i++) {
      arrivals.add(scan(i, 50_000));
    }
    assertThat(arrivals.upTo(sent)).as("there is room for as many again").hasSameSizeAs(due);
  }
}
