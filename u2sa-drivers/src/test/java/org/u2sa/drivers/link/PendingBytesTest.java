package org.u2sa.drivers.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class PendingBytesTest {
  private final MemoryLink link = new MemoryLink();
  private final PendingBytes pending = new PendingBytes();
  private final ByteArrayOutputStream read = new ByteArrayOutputStream();

  private void read() {
    pending.read(link, (bytes, length) -> read.write(bytes, 0, length));
  }

  @Test
  @Timeout(60)
  void read_deviceThatNeverStops_endsAtTheLimitAndGoesOnAtTheNextCall() {
    link.producing(() -> link.fromDevice(new byte[4_096]));

    read();
    assertThat(read.size()).isEqualTo(PendingBytes.MAX_BYTES);
    read();
    assertThat(read.size()).isEqualTo(2 * PendingBytes.MAX_BYTES);
  }

  @Test
  void read_fewBytes_allAreDelivered() {
    link.fromDevice(new byte[5_000]);
    read();
    assertThat(read.size()).isEqualTo(5_000);
  }
}
