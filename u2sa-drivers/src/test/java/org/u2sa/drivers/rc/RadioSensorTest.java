package org.u2sa.drivers.rc;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.port.RadioReceiver;
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

  private List<ManualState> states() {
    return kit.published(Channels.MANUAL_STATE);
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

  @Test
  void step_pulsesEnd_isManual() {
    start();
    hold(0.002, 0.5);
    hold(0.0, 0.5);

    assertThat(states()).extracting(ManualState::active).containsExactly(false, true);
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
