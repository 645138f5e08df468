package org.u2sa.flightgear.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.sim.aircraft.ControlInputs;

/** What may happen to controls on their way, and that nothing of it reaches the service. */
final class FlightGearControlsTest extends RawLink {
  @Test
  void write_whileTheEngineStarts_sendsThrottleAndMixtureThatItSurvives() throws IOException {
    flightGear.connect(link.outPort());
    flightGear.send(RawFlightGear.lineOfStartingEngine());
    link.write(SOME.withThrottle(1.0).withMixture(0.0));
    assertThat(flightGear.acceptControls().readLine())
        .startsWith("0.100000,-0.200000,0.300000,0.000000,0.480000,1.000000,");
  }

  @Test
  void write_beforeAnyLine_doesNotConnectThenSendsTheNewestFirst() throws IOException {
    link.write(SOME.withThrottle(0.9));
    link.write(SOME);
    flightGear.connect(link.outPort());
    flightGear.send(RawFlightGear.line(5.0, 1.0));
    assertThat(flightGear.acceptControls().readLine())
        .isEqualTo("0.100000,-0.200000,0.300000,0.000000,0.400000,1.000000,0.000000,0.000000,1");
  }

  @Test
  void write_controlConnectionClosed_connectsAgainAndSaysSo() throws IOException {
    flightGear.connect(link.outPort());
    flightGear.send(RawFlightGear.line(5.0, 1.0));
    link.write(SOME);
    flightGear.acceptControls().readLine();
    flightGear.closeControls();
    awaitTrouble("controls do not reach FlightGear at 127.0.0.1:" + flightGear.inPort());
    assertThat(flightGear.acceptControls().readLine()).startsWith("0.100000,-0.200000");
    awaitTrouble("controls go to FlightGear again");
  }

  @Test
  void write_nobodyTakesControls_saysSoOnceAndReadingGoesOn() throws IOException {
    flightGear.stopListening();
    flightGear.connect(link.outPort());
    flightGear.send(RawFlightGear.line(5.0, 1.0));
    link.write(SOME);
    awaitTrouble("controls do not reach FlightGear");
    for (int i = 0; i < 20; i++) {
      flightGear.send(RawFlightGear.line(5.1 + i, 1.0));
      link.write(SOME);
    }
    readUntil(each -> each.connected() && each.sequence() == 21);
    troubles.append(link.trouble());
    assertThat(troubles.toString()).containsOnlyOnce("controls do not reach FlightGear");
  }

  @Test
  void write_flightGearThatDoesNotRead_neverBlocks() throws IOException {
    flightGear.connect(link.outPort());
    flightGear.send(RawFlightGear.line(5.0, 1.0));
    link.write(SOME);
    flightGear.acceptControls();
    long before = clock.micros();
    for (int i = 0; i < 200_000; i++) {
      link.write(SOME);
    }
    assertThat(clock.micros() - before).isLessThan(5 * Clock.MICROS_PER_SECOND);
  }

  @Test
  void close_afterWrite_sendsTheLastControlsAndAWholeLine() throws IOException {
    flightGear.connect(link.outPort());
    flightGear.send(RawFlightGear.line(5.0, 1.0));
    link.write(SOME);
    BufferedReader controls = flightGear.acceptControls();
    assertThat(controls.readLine()).startsWith("0.100000,");
    link.write(SOME.withThrottle(0.9));
    link.write(ControlInputs.neutral());
    link.close();
    String last = controls.lines().reduce("", (one, next) -> next);
    assertThat(last).startsWith("0.000000,0.000000,0.000000,0.000000,0.000000,1.000000,");
    assertThat(link.read(clock.micros()).connected()).isFalse();
    assertThat(flightGear.isRefused()).isTrue();
  }
}
