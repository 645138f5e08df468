package org.u2sa.world.egocentric;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.Sighting;

/** A vehicle that turns right while it moves ahead, with its nose down, and a buoy. */
class EgocentricModellerTest {
  private static final Point BUOY = Point.of(6.0, 1.0, 2.0); // north, east, down of the start [m]
  private static final double TURN_RAD_PER_S = 0.2;
  private static final double SPEED_MPS = 0.4;
  private static final double PITCH_RAD = -0.2;
  private static final int STEP_MICROS = 20_000;

  private final EgocentricModeller modeller =
      new EgocentricModeller(XmlConfiguration.inMemory("test", Map.of()));
  private Point at = Point.ORIGIN;
  private double psi;
  private long micros;

  /** Moves level, along the heading. */
  private void move(double seconds, boolean hasLog) {
    for (long end = micros + (long) (1e6 * seconds); micros < end; micros += STEP_MICROS) {
      double dt = 1e-6 * STEP_MICROS;
      psi += TURN_RAD_PER_S * dt;
      at = at.plus(Point.of(Math.cos(psi), Math.sin(psi), 0.0).times(SPEED_MPS * dt));
      StateInformation imu = new StateInformation().referenceFrame(ReferenceFrame.GLOBAL);
      imu.phi(0.0).theta(PITCH_RAD).psiDot(TURN_RAD_PER_S).timestamp(micros + STEP_MICROS);
      modeller.sensed(imu);
      if (hasLog) {
        Point body = new Attitude(0.0, PITCH_RAD, 0.0).bodyOf(Point.of(SPEED_MPS, 0.0, 0.0));
        StateInformation log = new StateInformation().referenceFrame(ReferenceFrame.BODY);
        log.xDot(body.x()).yDot(body.y()).zDot(body.z()).timestamp(micros + STEP_MICROS);
        modeller.sensed(log);
      }
    }
  }

  private Sighting now() {
    return new Sighting(micros, MapFrame.BODY, Optional.empty());
  }

  private void see(double sigmaM) {
    Point body = new Attitude(0.0, PITCH_RAD, psi).bodyOf(BUOY.minus(at));
    ObjectDescription object = new ObjectDescription();
    object.objectType("buoy").sensorName("Camera").referenceFrame(ReferenceFrame.BODY);
    object.x(body.x()).y(body.y()).z(body.z()).timestamp(micros);
    object.motion().sigma(Point.of(sigmaM, sigmaM, sigmaM));
    modeller.objects(List.of(object), now());
  }

  private double errorM() {
    Point level = new Attitude(0.0, 0.0, psi).bodyOf(BUOY.minus(at));
    return modeller.objects(now()).get(0).center().distanceTo(level);
  }

  @Test
  void objects_outOfSightWhileTheVehicleMoves_isCarriedAlong() {
    move(1.0, true);
    see(0.1);
    assertThat(errorM()).isLessThan(1e-6);
    move(10.0, true);

    assertThat(errorM()).isLessThan(0.05);
  }

  @Test
  void objects_withoutVelocityLog_turnsAlongOnly() {
    move(1.0, false);
    see(0.1);
    move(5.0, false);

    assertThat(errorM()).isBetween(1.5, 2.1);
    assertThat(modeller.remark()).contains("speed unknown");
    see(0.1);
    assertThat(errorM()).as("corrected by half").isLessThan(1.1);
  }

  @Test
  void objects_onlyTheDirectionIsMeasured_theNewestCounts() {
    move(1.0, false);
    see(10.0);
    move(5.0, false);
    see(10.0);

    assertThat(modeller.objects(now())).hasSize(1);
    assertThat(errorM()).isLessThan(1e-6);
  }

  @Test
  void objects_unseenForLong_areForgotten() {
    move(1.0, true);
    see(0.1);
    move(21.0, true);

    assertThat(modeller.objects(now())).isEmpty();
  }
}
