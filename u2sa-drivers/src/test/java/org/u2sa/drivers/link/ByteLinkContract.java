package org.u2sa.drivers.link;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import org.awaitility.core.ConditionFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What a service may rely on, whatever is between it and the device. */
abstract class ByteLinkContract {
  /** Long enough for a loaded machine: a device is found again within about a second. */
  static final Duration PATIENCE = Duration.ofSeconds(30);

  private final StringBuilder heard = new StringBuilder();
  ByteLink link;

  /** A device that is there and has said nothing yet. */
  abstract FarEnd device() throws Exception;

  private FarEnd device;

  @BeforeEach
  void open() throws Exception {
    device = device();
    link = device.open();
  }

  @AfterEach
  void close() throws Exception {
    if (link != null) { // else the device could not be made, and that is what is to be reported
      link.close();
    }
    if (device != null) {
      device.end();
    }
  }

  private static ConditionFactory soon() {
    return await().atMost(PATIENCE).pollInterval(Duration.ofMillis(10));
  }

  /** One turn of a service: looks for a new connection, then reads. */
  void turn() {
    link.connections();
    byte[] buffer = new byte[7]; // smaller than what comes at once
    for (int count = link.read(buffer); count > 0; count = link.read(buffer)) {
      heard.append(new String(buffer, 0, count, US_ASCII));
    }
  }

  private void untilHeard(String text) {
    soon()
        .until(
            () -> {
              turn();
              return heard.indexOf(text) >= 0;
            });
  }

  /** As a service that polls its device; some transports lose what is said before all is set up. */
  private void greet() throws Exception {
    soon()
        .until(
            () -> {
              link.write("?".getBytes(US_ASCII));
              device.says("hello\n");
              turn();
              return heard.indexOf("hello\n") >= 0;
            });
  }

  private void untilLost() {
    soon()
        .until(
            () -> {
              turn();
              return !link.isConnected();
            });
  }

  @Test
  void read_deviceSpeaks_allComesInOrder() throws Exception {
    greet();
    StringBuilder said = new StringBuilder();
    for (int i = 0; i < 50; i++) {
      said.append("line ").append(i).append('\n');
    }
    device.says(said.toString());

    untilHeard("line 49\n");

    assertThat(heard.toString()).endsWith(said.toString());
    assertThat(link.isConnected()).isTrue();
    assertThat(link.trouble()).isEmpty();
    assertThat(link.connections()).isEqualTo(1);
  }

  @Test
  void write_deviceIsThere_deviceIsToldAllInOrder() throws Exception {
    greet();
    assertThat(link.write("first ".getBytes(US_ASCII))).isTrue();
    assertThat(link.write("second".getBytes(US_ASCII))).isTrue();

    if (device.listens()) {
      soon().until(() -> device.wasTold().endsWith("first second"));
    }
  }

  @Test
  void read_deviceUnplugged_lostIsSaidAndNothingComes() throws Exception {
    greet();
    device.unplug();
    untilLost();

    assertThat(link.trouble()).isNotEmpty();
    assertThat(link.read(new byte[8])).isZero();
    assertThat(link.connections()).isEqualTo(1);
  }

  @Test
  void read_devicePluggedAgain_isFoundAgainByItself() throws Exception {
    greet();
    device.unplug();
    untilLost();
    heard.setLength(0);
    device.plug();
    greet();

    assertThat(link.isConnected()).isTrue();
    assertThat(link.connections()).isEqualTo(2);
    assertThat(link.write("again".getBytes(US_ASCII))).isTrue();
    if (device.listens()) {
      soon().until(() -> device.wasTold().endsWith("again"));
    }
  }

  @Test
  void read_newConnectionNotLookedAt_nothingOfItComes() throws Exception {
    greet();
    device.says("half a sent");
    untilHeard("half a sent");
    device.unplug();
    untilLost();
    device.plug();
    soon() // found again, and the owner has not looked yet
        .until(
            () -> {
              link.write("?".getBytes(US_ASCII));
              device.says("whole\n");
              return link.isConnected();
            });

    assertThat(link.read(new byte[8])).isZero();
    assertThat(link.connections()).isEqualTo(2);
  }

  @Test
  void close_somethingWasWrittenBefore_deviceIsStillToldIt() throws Exception {
    greet();
    device.says("that was all\n");
    untilHeard("that was all\n");
    link.write("stop the motors".getBytes(US_ASCII));
    link.close();

    if (device.hearsTheLast()) {
      soon().until(() -> device.wasTold().endsWith("stop the motors"));
    }
  }

  @Test
  void close_deviceIsThere_linkIsDead() throws Exception {
    greet();
    link.close();
    link.close();

    assertThat(link.isConnected()).isFalse();
    assertThat(link.write(new byte[1])).isFalse();
    assertThat(
            Thread.getAllStackTraces().keySet().stream()
                .map(Thread::getName)
                .filter(name -> name.startsWith("link ") && name.endsWith(device.address())))
        .isEmpty();
  }
}
