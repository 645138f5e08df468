package org.u2sa.flightgear.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.concurrent.Callable;
import org.awaitility.core.ConditionTimeoutException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.flightgear.protocol.OutField;
import org.u2sa.flightgear.protocol.OutLine;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.RunwayStart;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.testkit.FreePort;

/**
 * The stand-in is worth what it shares with the real one: docs/flightgear.md lists what was seen
 * there.
 */
final class StandInFlightGearTest {
  private static final String ROLL_RIGHT = "0.5,0,0,0,0.2,1,0,0,1\n";

  private final Clock clock = new SystemClock();
  private StandInFlightGear standIn;

  @AfterEach
  void close() {
    if (standIn != null) {
      standIn.close();
    }
  }

  @Test
  void start_peerListens_sendsLinesFromBeforeTheFlightModelFirst() throws Exception {
    try (ServerSocket peer = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      start(new StandInSetup(100.0, 10.0, 0.2, 7.5), peer.getLocalPort());
      try (Socket lines = peer.accept()) {
        BufferedReader reader =
            new BufferedReader(
                new InputStreamReader(lines.getInputStream(), StandardCharsets.US_ASCII));
        OutLine first = OutLine.parse(reader.readLine());
        assertThat(first.isBeforeFlight()).isTrue();
        assertThat(first.get(OutField.ELAPSED)).isZero();
        assertThat(first.format()).contains("-9999.000000");
        OutLine line = first;
        while (line.isBeforeFlight()) {
          line = OutLine.parse(reader.readLine());
        }
        assertThat(line.isSet(OutField.PRIMER)).isTrue();
        assertThat(line.get(OutField.HEIGHT))
            .isBetween(OutLine.STANDING_M - 0.1, OutLine.STANDING_M + 0.1);
        while (line.get(OutField.ELAPSED) < 8.0) {
          line = OutLine.parse(reader.readLine());
        }
        assertThat(line.isSet(OutField.PRIMER)).isFalse();
        assertThat(line.get(OutField.ENGINE_SPEED)).isGreaterThan(500.0);
      }
    }
  }

  @Test
  void told_fullThrottleWhileTheEngineStarts_engineDies() throws IOException {
    start(new StandInSetup(100.0, 10.0, 0.0, 7.5), FreePort.find());
    try (Socket controls = controls()) {
      say(controls, "0,0,0,0,1,1,0,0,1\n");
      until(() -> standIn.said().get(OutField.ELAPSED) > 9.0);
      assertThat(standIn.said().get(OutField.ENGINE_SPEED)).isLessThan(100.0);
    }
  }

  @Test
  void told_closedAfterAWholeLine_nextClientIsHeard() throws IOException {
    start(StandInSetup.ready(200.0, 1.0), FreePort.find());
    hear(ROLL_RIGHT);
    until(() -> standIn.told().controls().aileron() == 0.5);
    hear("-0.25\n");
    until(() -> standIn.told().controls().aileron() == -0.25);
    assertThat(standIn.told().controls().throttle()).isEqualTo(0.2);
  }

  @Test
  void told_closedInTheMiddleOfALine_nobodyIsHeardAgain() throws IOException {
    start(StandInSetup.ready(200.0, 1.0), FreePort.find());
    hear("0.25\n0.5,0");
    until(() -> standIn.told().controls().aileron() == 0.25);
    try (Socket controls = controls()) {
      say(controls, ROLL_RIGHT);
      assertThatThrownBy(
              () -> until(Duration.ofMillis(200), () -> standIn.told().controls().aileron() == 0.5))
          .isInstanceOf(ConditionTimeoutException.class);
    }
  }

  @Test
  void told_nan_channelIsGoneAndSaysWhy() throws IOException {
    start(StandInSetup.ready(200.0, 1.0), FreePort.find());
    hear("nan\n");
    until(() -> standIn.trouble().contains("would corrupt the flight model"));
  }

  @Test
  void propertyServer_getAndExit_answersLikeFlightGear() throws IOException {
    start(StandInSetup.ready(200.0, 1.0), FreePort.find());
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), standIn.propertyPort())) {
      BufferedReader answers =
          new BufferedReader(
              new InputStreamReader(socket.getInputStream(), StandardCharsets.US_ASCII));
      say(socket, "data\r\nget /gear/gear[1]/wow\r\n");
      assertThat(answers.readLine()).isEqualTo("1.000000000");
      say(socket, "run nonsense\r\n");
      assertThat(answers.readLine()).isEqualTo("*failed*");
      say(socket, "run exit\r\n");
      assertThat(answers.readLine()).isEqualTo("<completed>");
      assertThat(answers.readLine()).isNull();
    }
  }

  private void start(StandInSetup setup, int outPort) throws IOException {
    boolean running = setup.primerS() == 0.0;
    Cessna172 aircraft =
        Cessna172.onRunway(
            new RunwayStart(-157.943183, 21.325247, 5.3, 1.57), Wind.calm(), running);
    standIn = new StandInFlightGear(aircraft, setup, "127.0.0.1", 0, 0, clock);
    standIn.start("127.0.0.1", outPort);
  }

  private Socket controls() throws IOException {
    return new Socket(InetAddress.getLoopbackAddress(), standIn.inPort());
  }

  private void hear(String text) throws IOException {
    try (Socket controls = controls()) {
      say(controls, text);
    }
  }

  private static void say(Socket socket, String text) throws IOException {
    socket.getOutputStream().write(text.getBytes(StandardCharsets.US_ASCII));
    socket.getOutputStream().flush();
  }

  private static void until(Callable<Boolean> condition) {
    until(Duration.ofSeconds(60), condition);
  }

  private static void until(Duration patience, Callable<Boolean> condition) {
    await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(2))
        .atMost(patience)
        .until(condition);
  }
}
