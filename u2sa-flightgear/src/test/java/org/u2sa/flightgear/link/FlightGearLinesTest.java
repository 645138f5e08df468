package org.u2sa.flightgear.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import org.junit.jupiter.api.Test;
import org.u2sa.flightgear.protocol.LineSplitter;
import org.u2sa.interfaces.communication.CommunicationException;

/** What FlightGear and others may do to the connection of lines. */
final class FlightGearLinesTest extends RawLink {
  @Test
  void constructor_portTaken_saysWhichAndWhatToDo() throws IOException {
    try (ServerSocket other = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      assertThatThrownBy(() -> new FlightGearLink("127.0.0.1", other.getLocalPort(), 1, 0, clock))
          .isInstanceOf(CommunicationException.class)
          .hasMessageContaining("127.0.0.1:" + other.getLocalPort())
          .hasMessageContaining("out-port");
    }
  }

  @Test
  void read_flightGearAbsent_isNotConnectedAndSaysThatItWaits() {
    link.write(SOME);
    assertThat(link.read(clock.micros())).isEqualTo(AircraftReading.none());
    assertThat(link.trouble()).isEqualTo("waiting for FlightGear on 127.0.0.1:" + link.outPort());
  }

  @Test
  void read_flightGearAbsentButPropertyPortKnown_saysOnceThatNobodyIsThere() throws IOException {
    link.close();
    int nobody = flightGear.inPort();
    flightGear.stopListening();
    link = new FlightGearLink("127.0.0.1", 0, 1, nobody, clock);
    awaitTrouble("property server 127.0.0.1:" + nobody);
  }

  @Test
  void read_linesFromBeforeTheFlightModel_areNoReadings() throws IOException {
    flightGear.connect(link.outPort());
    flightGear.send(RawFlightGear.line(0.0, 1.0));
    awaitTrouble("FlightGear connected");
    assertThat(link.read(clock.micros()).connected()).isFalse();
    flightGear.send(RawFlightGear.line(0.05, 2.0));
    assertThat(readUntil(AircraftReading::connected).state().psi().orElse(0.0))
        .isBetween(1.99, 2.01);
    assertThat(link.refusedLines()).isZero();
  }

  @Test
  void read_lineHalvedByPackets_isReadWhole() throws IOException {
    String line = RawFlightGear.line(5.0, 1.25);
    flightGear.connect(link.outPort());
    flightGear.send(RawFlightGear.line(4.0, 1.0) + line.substring(0, 70));
    assertThat(readUntil(AircraftReading::connected).state().psi().orElse(0.0))
        .isBetween(0.99, 1.01);
    flightGear.send(line.substring(70));
    assertThat(readUntil(each -> each.sequence() == 2).state().psi().orElse(0.0))
        .isBetween(1.24, 1.26);
  }

  @Test
  void read_slowPeerByteByByte_isReadWhole() throws IOException {
    flightGear.connect(link.outPort());
    for (char each : RawFlightGear.line(5.0, 1.25).toCharArray()) {
      flightGear.send(String.valueOf(each));
    }
    assertThat(readUntil(AircraftReading::connected).state().psi().orElse(0.0))
        .isBetween(1.24, 1.26);
  }

  @Test
  void read_garbage_isRefusedAndTheNextLineIsRead() throws IOException {
    flightGear.connect(link.outPort());
    flightGear.send(
        "0 HTTP/1.0\r\n\n\0\u00ff\n1,2,3\n"
            + RawFlightGear.line(5.0, 1.0).replaceFirst("^5[^,]*", "nan"));
    flightGear.send(RawFlightGear.line(5.0, 1.25));
    assertThat(readUntil(AircraftReading::connected).state().psi().orElse(0.0))
        .isBetween(1.24, 1.26);
    assertThat(link.refusedLines()).isEqualTo(5);
    awaitTrouble(
        "5 lines from FlightGear refused, the last: /sim/time/elapsed-sec: \"nan\" is not a number");
  }

  /** As a page in a browser sends it, without asking. */
  @Test
  void read_httpRequestWithLinesInItsBody_isClosedAndNoFlightGear() throws IOException {
    flightGear.connect(link.outPort());
    flightGear.send("POST / HTTP/1.1\r\n\r\n" + RawFlightGear.line(5.0, 1.25));
    assertThat(flightGear.isRefused()).isTrue();
    awaitTrouble("was closed: it began with no number");
    assertThat(link.read(clock.micros()).connected()).isFalse();
  }

  @Test
  void read_endlessLine_isRefusedAndTheNextLineIsRead() throws IOException {
    flightGear.connect(link.outPort());
    flightGear.send("7".repeat(3 * LineSplitter.LONGEST) + "\n" + RawFlightGear.line(5.0, 1.25));
    readUntil(AircraftReading::connected);
    awaitTrouble("1 line from FlightGear refused: longer than 2048 bytes");
  }

  @Test
  void read_flightGearGone_isNotConnectedKeepsTheLastValuesAndComesBack() throws IOException {
    flightGear.connect(link.outPort());
    flightGear.send(RawFlightGear.line(5.0, 1.25) + "6.0,1");
    readUntil(AircraftReading::connected);
    flightGear.closeLines();
    AircraftReading last = readUntil(each -> !each.connected());
    assertThat(last.state().psi().orElse(0.0)).isBetween(1.24, 1.26);
    awaitTrouble("FlightGear closed the connection of its lines in the middle of a line");
    flightGear.connect(link.outPort());
    flightGear.send(RawFlightGear.line(5.2, 1.5));
    assertThat(readUntil(AircraftReading::connected).sequence()).isEqualTo(2);
    awaitTrouble("FlightGear is connected again");
  }

  @Test
  void read_flightGearSilentForASecond_isNotConnectedUntilItSpeaksAgain() throws IOException {
    flightGear.connect(link.outPort());
    flightGear.send(RawFlightGear.line(5.0, 1.0));
    AircraftReading first = readUntil(AircraftReading::connected);
    assertThat(link.read(first.measuredAtMicros() + 900_000).connected()).isTrue();
    assertThat(link.read(first.measuredAtMicros() + 1_100_000).connected()).isFalse();
    awaitTrouble("silent for more than 1 s");
    flightGear.send(RawFlightGear.line(6.5, 1.0));
    readUntil(AircraftReading::connected);
    awaitTrouble("FlightGear's lines resumed after 1.");
  }

  @Test
  void read_secondSenderWhileOneIsConnected_isRefused() throws IOException {
    flightGear.connect(link.outPort());
    flightGear.send(RawFlightGear.line(5.0, 1.0));
    readUntil(AircraftReading::connected);
    try (RawFlightGear second = new RawFlightGear()) {
      second.connect(link.outPort());
      second.send(RawFlightGear.line(50.0, 3.0));
      assertThat(second.isRefused()).isTrue();
    }
    flightGear.send(RawFlightGear.line(5.1, 1.5));
    assertThat(readUntil(each -> each.sequence() == 2).state().psi().orElse(0.0))
        .isBetween(1.49, 1.51);
    awaitTrouble("a second sender of lines");
  }

  @Test
  void read_strayConnectionsThatSayNothing_doNotKeepFlightGearOut() throws IOException {
    try (RawFlightGear stray = new RawFlightGear()) {
      for (int i = 0; i < 10; i++) {
        stray.connect(link.outPort());
      }
      flightGear.connect(link.outPort());
      flightGear.send(RawFlightGear.line(5.0, 1.0));
      readUntil(AircraftReading::connected);
    }
  }
}
