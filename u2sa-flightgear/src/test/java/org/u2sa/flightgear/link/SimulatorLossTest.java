package org.u2sa.flightgear.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.AircraftState;
import org.u2sa.sim.aircraft.ControlInputs;
import org.u2sa.testkit.ServiceKit;

/** What control systems are told while the aircraft is lost. */
class SimulatorLossTest {
  private final ServiceKit kit = new ServiceKit();
  private boolean isThere;

  @AfterEach
  void close() {
    kit.close();
  }

  private AircraftLink link() {
    return new AircraftLink() {
      @Override
      public AircraftReading read(long nowMicros) {
        return new AircraftReading(isThere, 0, 0, new AircraftState());
      }

      @Override
      public void write(ControlInputs controls) {
        // nobody is there to obey
      }

      @Override
      public String trouble() {
        return "";
      }

      @Override
      public void close() {
        isThere = false;
      }
    };
  }

  /** What is left of each control, by its newest announcement [%]. */
  private Map<String, Double> left() {
    Map<String, Double> left = new TreeMap<>();
    kit.published(Channels.ACTUATORS)
        .forEach(each -> left.put(each.actuatorName(), each.available().orElse(100.0)));
    return left;
  }

  @Test
  void step_aircraftIsLostAndComesBack_controlsAreAnnouncedAsLostMeanwhile() {
    isThere = true;
    Simulator simulator = kit.start(context -> new Simulator(context, link()));
    kit.advance(0.1);
    assertThat(left()).hasSize(8).containsEntry("AILERON", 100.0);
    isThere = false;
    kit.advance(0.1);
    assertThat(left().values()).containsOnly(0.0);
    isThere = true;
    kit.advance(0.1);
    assertThat(left().values()).containsOnly(100.0);
    simulator.kill();
    assertThat(left().values()).containsOnly(0.0);
  }
}
