package org.u2sa.drivers.rc;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.device.port.RadioReceiver;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.service.ServiceContext;
import org.u2sa.testkit.ServiceKit;

/** The switch at channel 2 of a radio. */
class RadioSensorTest {
  private final ServiceKit kit = new ServiceKit().with("SWITCH CHANNEL", 2);
  private double widthS = 0.002; // 0: no pulses

  @AfterEach
  void close() {
    kit.close();
  }

  private RadioSensor sensor(ServiceContext context) {
    RadioReceiver receiver =
        nowMicros ->
            widthS == 0.0
                ? Optional.empty()
                : Optional.of(new RadioReceiver.Pulses(nowMicros, List.of(0.0015, widthS)));
    return new RadioSensor(context, receiver);
  }

  private RadioSensor start() {
    return kit.start(this::sensor);
  }

  private void hold(double switchS, double seconds) {
    widthS = switchS;
    for (double t = 0.0; t < seconds; t += 0.02) {
      kit.advance(0.02);
    }
  }

  /** The states without their repetitions. */
  private List<ManualState> states() {
    List<ManualState> changes = new ArrayList<>();
    for (ManualState state : kit.published(Channels.MANUAL_STATE)) {
      if (changes.isEmpty() || changes.get(changes.size() - 1).active() != state.active()) {
        changes.add(state);
      }
    }
    return changes;
  }

  /** A control system that no longer hears it takes it for ended. */
  @Test
  void step_pilotFlies_isRepeatedAlsoWithoutTheRadio() {
    start();
    hold(0.002, 0.5);
    hold(0.001, 0.5);
    hold(0.0, 2.0);
    kit.forget();
    hold(0.0, 2.0);

    assertThat(kit.published(Channels.MANUAL_STATE))
        .hasSizeBetween(3, 5)
        .allMatch(ManualState::active);
  }

  @Test
  void step_switchToManualAndBackTwice_countsTwoTakeovers() {
    start();
    hold(0.002, 0.5);
    hold(0.001, 0.5);
    hold(0.002, 0.5);
    hold(0.001, 0.5);

    assertThat(states()).extracting(ManualState::active).containsExactly(false, true, false, true);
    assertThat(states()).extracting(ManualState::takeovers).containsExactly(0L, 1L, 1L, 2L);
  }

  /** The Safety Manager believes its state only with this remark. */
  @Test
  void step_pilotFlies_isConfirmedInHealthUntilHeGivesBackAndAfterARestart() {
    RadioSensor before = start();
    hold(0.002, 0.5);
    assertThat(confirmations()).isEmpty();
    hold(0.001, 0.5);
    assertThat(confirmations()).containsExactly("BY HAND: pilot");
    kit.restart(before, this::sensor);
    hold(0.001, 0.5);
    assertThat(confirmations()).containsExactly("BY HAND: pilot");
    hold(0.002, 0.5);
    assertThat(confirmations()).isEmpty();
  }

  private List<String> confirmations() {
    return kit.latest(Channels.HEALTH).orElseThrow().remarks().stream()
        .filter(remark -> remark.startsWith(ManualState.REMARK))
        .toList();
  }

  @Test
  void step_noReceiverYet_isNoTakeover() {
    start();
    hold(0.0, 1.0);
    hold(0.001, 0.5);
    assertThat(states()).isEmpty();
  }

  private String loss() {
    return kit.latest(Channels.HEALTH).orElseThrow().remarks().stream()
        .filter(remark -> remark.startsWith(ManualState.LOSS_REMARK))
        .findFirst()
        .orElse("");
  }

  /** An unplugged receiver is no pilot: nobody would fly. */
  @Test
  void step_pulsesEndAtAutomatic_staysAutomaticAndTheLossIsReported() {
    start();
    hold(0.002, 0.5);
    hold(0.0, 3.0);

    assertThat(states()).extracting(ManualState::active).containsExactly(false);
    assertThat(confirmations()).isEmpty();
    assertThat(loss()).isEqualTo("RADIO LOST: automatic control continues");
    assertThat(kit.log("RadioSensor"))
        .anyMatch(line -> line.contains("the pilot's radio is lost: automatic control continues"));

    hold(0.002, 1.0);
    assertThat(states()).hasSize(1);
    assertThat(loss()).isEmpty();
    assertThat(kit.log("RadioSensor"))
        .anyMatch(line -> line.contains("the pilot's radio is back: AUTOMATIC"));
  }

  /** The multiplexer may still connect the pilot, who only the cable cannot be heard by. */
  @Test
  void step_pulsesEndAtManual_staysManualUntilTheSwitchIsHeardAtAutomatic() {
    start();
    hold(0.002, 0.5);
    hold(0.001, 0.5);
    hold(0.0, 3.0);
    assertThat(states()).extracting(ManualState::active).containsExactly(false, true);
    assertThat(confirmations()).containsExactly("BY HAND: pilot");
    assertThat(loss()).isEqualTo("RADIO LOST: control stays with the pilot");

    hold(0.001, 0.5);
    assertThat(states()).hasSize(2);
    assertThat(loss()).isEmpty();
    hold(0.002, 0.5);
    assertThat(states()).extracting(ManualState::active).containsExactly(false, true, false);
    assertThat(states()).extracting(ManualState::takeovers).containsExactly(0L, 1L, 1L);
  }

  @Test
  void step_radioReturnsAtManual_isTakenOverAtOnce() {
    start();
    hold(0.002, 0.5);
    hold(0.0, 3.0);
    hold(0.001, 0.1);

    assertThat(states()).extracting(ManualState::active).containsExactly(false, true);
  }

  @Test
  void step_multiplexerFallsToAutomatic_isGivenBackAfterASecondAndTakenOverAtTheReturn() {
    kit.with("MULTIPLEXER AT LOSS", "AUTOMATIC");
    start();
    hold(0.002, 0.5);
    hold(0.001, 0.5);
    hold(0.0, 0.9);
    assertThat(states()).extracting(ManualState::active).containsExactly(false, true);
    hold(0.0, 0.5);
    assertThat(states()).extracting(ManualState::active).containsExactly(false, true, false);
    hold(0.001, 0.5);
    assertThat(states()).extracting(ManualState::active).last().isEqualTo(true);
    assertThat(states()).extracting(ManualState::takeovers).last().isEqualTo(2L);
  }

  /** Its successor, which hears nothing, reports what it has not seen itself. */
  @Test
  void restart_whileTheRadioIsLost_theLossIsReportedAgain() {
    RadioSensor before = start();
    hold(0.002, 0.5);
    hold(0.0, 2.0);
    kit.restart(before, this::sensor);
    hold(0.0, 0.5);
    assertThat(loss()).isEmpty();
    hold(0.0, 1.5);

    assertThat(loss()).isEqualTo("RADIO LOST: automatic control continues");
    assertThat(states()).extracting(ManualState::active).containsExactly(false);
  }

  /** Halves of two frames have a right checksum once in 256 times. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void step_noiseAndHalfFrames_neverTakesOver(boolean halves) {
    MemoryLink wire = new MemoryLink();
    Random random = new Random(7);
    kit.start(context -> new RadioSensor(context, new CrsfReceiver(wire)));
    byte[] automatic = frame(1811);
    for (int i = 0; i < 10_000; i++) {
      byte[] noise = new byte[400];
      random.nextBytes(noise);
      byte[] half = Arrays.copyOf(frame(random.nextInt(1811)), 1 + random.nextInt(25));
      wire.fromDevice(i < 10 ? automatic : halves ? half : noise);
      kit.advance(0.02);
    }

    assertThat(states()).extracting(ManualState::active).containsExactly(false);
  }

  /** A frame with all channels at a value. */
  private static byte[] frame(int value) {
    BigInteger channels = BigInteger.ZERO;
    for (int channel = 0; channel < 16; channel++) {
      channels = channels.or(BigInteger.valueOf(value).shiftLeft(11 * channel));
    }
    byte[] frame = new byte[26];
    frame[0] = (byte) 0xC8;
    frame[1] = 24;
    frame[2] = 0x16;
    for (int i = 0; i < 22; i++) {
      frame[3 + i] = channels.shiftRight(8 * i).byteValue();
    }
    frame[25] = (byte) CrsfReceiver.crc(frame, 2, 25);
    return frame;
  }

  @Test
  void restart_whileThePilotFlies_givingBackIsTold() {
    RadioSensor before = start();
    hold(0.002, 0.5);
    hold(0.001, 0.5);
    kit.restart(before, this::sensor);
    hold(0.001, 0.5);
    hold(0.002, 0.5);

    assertThat(states()).extracting(ManualState::active).containsExactly(false, true, false);
    assertThat(states()).extracting(ManualState::takeovers).containsExactly(0L, 1L, 1L);
  }

  /** The retained state of one that was killed before it could save anything, or of another run. */
  @Test
  void step_automaticForTheFirstTime_isTold() {
    start();
    hold(0.001, 0.5);
    assertThat(states()).isEmpty();
    hold(0.002, 0.5);

    assertThat(states()).extracting(ManualState::active).containsExactly(false);
  }
}
