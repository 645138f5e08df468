package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.messages.shape.Cylinder;

/** Altitudes at which objects are approached, here to within 20 m. */
class ObjectGoalTest extends PlannedVehicle {
  @ParameterizedTest
  @CsvSource({
    "50, 30, 40", // a mast of 30 m, from above: 10 m over its top
    "35, 30, 35",
    "8, 30, 8", // beside it
    "50, 1, 11", // an aircraft does not dive at a barrel on the ground
    "-20, 1, -10" // a submarine comes up to a buoy
  })
  void plan_objectAheadAtAnotherAltitude_keepsItsOwnWithinHalfTheDistance(
      double altitudeM, double heightM, double expectedM) {
    kit.start(PathPlanner::new);
    goals(new ObjectGoal().uid("mast").objectType("mast").within(20.0));
    kit.publish(
        Channels.OBJECTS,
        new ObjectList()
            .objects(
                List.of(
                    new Cylinder()
                        .radius(0.5)
                        .height(heightM)
                        .uid("M")
                        .objectType("mast")
                        .referenceFrame(ReferenceFrame.LOCAL_NED)
                        .x(100.0)
                        .y(0.0)
                        .z(-0.5 * heightM))));
    kit.advance(0.1);
    kit.publish(Channels.STATE, state(0.0, 0.0, 0.0).z(-altitudeM));

    assertThat(point().x()).isCloseTo(100.0, within(1.0e-6));
    assertThat(altitudeM - point().z()).isCloseTo(expectedM, within(1.0e-6));
  }
}
