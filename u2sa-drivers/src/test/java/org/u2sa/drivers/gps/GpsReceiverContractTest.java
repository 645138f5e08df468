package org.u2sa.drivers.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import org.awaitility.core.ConditionFactory;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.device.port.GpsFix;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.FarEnd;
import org.u2sa.drivers.link.FarEnds;
import org.u2sa.drivers.nmea.Nmea;

/** A receiver is the same to its service, whatever is between: unplugged, garbled, cut off. */
class GpsReceiverContractTest {
  private static final String HALF = "$GPRMC,120030.00,A,3713.5";

  @TempDir Path folder;
  private FarEnd device;
  private ByteLink link;
  private LinkedGps receiver;
  private int second;

  enum Kind {
    MEMORY,
    RECORDED,
    TCP,
    UDP,
    SERIAL
  }

  private void open(Kind kind) throws Exception {
    device =
        switch (kind) {
          case MEMORY -> FarEnds.memory();
          case RECORDED -> FarEnds.recorded(folder.resolve("gps.rec"));
          case TCP -> FarEnds.tcp();
          case UDP -> FarEnds.udp();
          case SERIAL -> FarEnds.serial(folder.resolve("ttyGPS"));
        };
    link = device.open();
    receiver = LinkedGps.listening(link, new NmeaGps());
  }

  private static ConditionFactory soon() {
    return await().atMost(Duration.ofSeconds(30)).pollInterval(Duration.ofMillis(10));
  }

  /** The receiver says a position, again and again, until it arrives. */
  private GpsFix untilAt(double latitudeDeg) {
    soon()
        .until(
            () -> {
              second++;
              device.says(
                  Nmea.line(
                      String.format(
                          java.util.Locale.ROOT,
                          "GPRMC,12%02d%02d.00,A,%02d00.0000,N,08000.0000,W,0.0,,211126,,,A",
                          second / 60,
                          second % 60,
                          Math.round(latitudeDeg))));
              return fix().filter(fix -> fix.latitudeDeg() == latitudeDeg).isPresent();
            });
    return fix().orElseThrow();
  }

  private Optional<GpsFix> fix() {
    link.write("?".getBytes(java.nio.charset.StandardCharsets.US_ASCII)); // where answers go
    return receiver.read(1_000);
  }

  @ParameterizedTest
  @EnumSource(Kind.class)
  void read_receiverComesAndGoes_fixesAreItsOwn(Kind kind) throws Exception {
    open(kind);
    try {
      untilAt(10.0);
      receiver.read(1_000);
      assertThat(receiver.isConnected()).isTrue();
      assertThat(receiver.malformed()).isZero();

      device.says(HALF);
      fix();
      device.unplug();
      soon().until(() -> receiver.read(1_000).isPresent() && !receiver.isConnected());
      assertThat(receiver.trouble()).isNotEmpty();
      assertThat(fix().orElseThrow().latitudeDeg()).as("the last one stays").isEqualTo(10.0);

      device.plug();
      untilAt(20.0);
      assertThat(receiver.connections()).isEqualTo(2);
      assertThat(receiver.malformed()).as("half a sentence of before is forgotten").isZero();

      device.says("\u0001noise $$ \u007f" + HALF + HALF + "*00\r\n");
      untilAt(30.0);
      assertThat(receiver.malformed()).isPositive();
      receiver.read(1_000);
      assertThat(receiver.isConnected()).isTrue();
    } finally {
      receiver.close();
      device.end();
    }
  }
}
