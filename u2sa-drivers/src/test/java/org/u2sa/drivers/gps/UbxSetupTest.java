package org.u2sa.drivers.gps;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.drivers.link.MemoryLink;

class UbxSetupTest {
  private static final long TICK_MICROS = 100_000;

  private final MemoryLink link = new MemoryLink();
  private final SimulatedUblox receiver = new SimulatedUblox(link);
  private final UbxGps gps = new UbxGps();
  private final UbxSetup setup =
      new UbxSetup(List.of(UbxGps.NAV_POSLLH, UbxGps.NAV_VELNED, UbxGps.NAV_SOL), 9600, 5.0);
  private long now;

  UbxSetupTest() {
    gps.answersTo(setup::answered);
  }

  private void turns(int count) {
    byte[] buffer = new byte[512];
    for (int i = 0; i < count; i++) {
      setup.step(link, now);
      gps.accept(buffer, link.read(buffer), now);
      now += TICK_MICROS;
    }
  }

  @Test
  void step_receiverAnswers_allIsSaidOnceByteForByte() {
    turns(10);

    assertThat(receiver.heard())
        .containsExactly("CFG-PRT", "CFG-RATE", "CFG-MSG-0102", "CFG-MSG-0112", "CFG-MSG-0106");
    assertThat(setup.isDone()).isTrue();
    assertThat(setup.trouble()).isEmpty();
    receiver.solve();
    turns(1);
    assertThat(gps.latest().orElseThrow().valid()).isTrue();
  }

  @Test
  void step_answerIsLost_isRepeated() {
    receiver.deaf(true);
    turns(3);
    receiver.deaf(false);
    turns(20);

    assertThat(receiver.heard())
        .containsExactly(
            "CFG-PRT", "CFG-PRT", "CFG-RATE", "CFG-MSG-0102", "CFG-MSG-0112", "CFG-MSG-0106");
    assertThat(setup.trouble()).isEmpty();
  }

  @Test
  void step_receiverRefuses_isSaidAndTheRestGoesOn() {
    receiver.refuse("CFG-MSG-0112");
    turns(10);

    assertThat(setup.trouble()).isEqualTo("the receiver rejected CFG-MSG for 01-12");
    assertThat(receiver.heard()).endsWith("CFG-MSG-0112", "CFG-MSG-0106");
    assertThat(setup.isDone()).isTrue();
  }

  @Test
  void step_receiverIsDeaf_isSaidAndAskedAgainNowAndThen() {
    receiver.deaf(true);
    turns(25);
    assertThat(setup.trouble()).isEqualTo("the receiver does not acknowledge its setup (CFG-PRT)");
    assertThat(receiver.heard()).hasSize(4);
    turns(40);
    assertThat(receiver.heard()).as("not all the time").hasSize(4);
    receiver.deaf(false);
    turns(40);

    assertThat(setup.isDone()).isTrue();
    assertThat(setup.trouble()).isEmpty();
  }

  @Test
  void begin_afterReconnection_allIsSaidAgain() {
    turns(10);
    receiver.restart();
    setup.begin();
    turns(10);

    assertThat(receiver.heard()).hasSize(10);
    receiver.solve();
    turns(1);
    assertThat(gps.latest()).isPresent();
  }
}
