package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Box;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.vehicle.SimulatedVehicle;
import org.u2sa.sim.world.HeightMap;
import org.u2sa.sim.world.World;

/** Where vehicles stand at the start of a run. */
class VehicleStartTest {
  private static VehicleFile shipped(String name) {
    return VehicleFile.load(Path.of("../config").resolve(name));
  }

  private static World raised(VehicleFile file, double groundM) {
    double[] heights = {groundM, groundM, groundM, groundM};
    return file.emptyWorld().with(HeightMap.of(heights, 2, 200.0, 200.0));
  }

  private static World around(VehicleFile file, Box box) {
    box.uid("shed").referenceFrame(ReferenceFrame.LOCAL_ENU).x(3.0).y(0.0).z(0.0);
    return file.emptyWorld().with(List.of(box.length(2.0).width(2.0).height(2.0)));
  }

  @ParameterizedTest
  @CsvSource({
    "suas/hexacopter/vehicle.xml,5",
    "suas/hexacopter/vehicle.xml,-5",
    "suas/plane/vehicle.xml,5",
    "suas/plane/vehicle-belly.xml,5",
    "cessna/vehicle.xml,5",
    "cessna/vehicle.xml,-5",
    "vehicles/trainer.xml,5",
    "ugv/vehicle.xml,5"
  })
  void make_groundAboveOrBelowTheOrigin_standsAsOnLevelGround(String name, double groundM) {
    VehicleFile file = shipped(name);
    Point start = Point.of(10.0, 20.0, 0.0);
    SimulatedVehicle level = file.make(file.emptyWorld(), start, 1.0, 1);
    SimulatedVehicle raised = file.make(raised(file, groundM), start, 1.0, 1);

    level.step(3.0);
    raised.step(3.0);

    Point moved = raised.truth().position().minus(level.truth().position());
    assertThat(moved.z()).isCloseTo(groundM, within(0.01));
    assertThat(moved.x()).isCloseTo(0.0, within(0.01));
    assertThat(raised.isAground()).isFalse();
  }

  @ParameterizedTest
  @CsvSource({"otter,1", "bluerov2,1", "remus100,-2"})
  void make_vesselInTheGround_isRefusedInWords(String name, double bedM) {
    VehicleFile file = shipped("vehicles/" + name + ".xml");

    assertThatThrownBy(() -> file.make(raised(file, bedM), Point.of(0.0, 0.0, -5.0), 0.0, 1))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(
            name
                + ".xml: where the vehicle starts, 0.00 m east, 0.00 m north and -5.00 m up in the world, it touches ground; expected a free place");
  }

  @Test
  void make_vesselAboveTheBed_starts() {
    VehicleFile file = shipped("vehicles/bluerov2.xml");
    Point start = Point.of(0.0, 0.0, -5.0);

    assertThat(file.make(raised(file, -8.0), start, 0.0, 1).truth().position()).isEqualTo(start);
  }

  @ParameterizedTest
  @ValueSource(strings = {"suas/hexacopter/vehicle.xml", "ugv/vehicle.xml", "vehicles/otter.xml"})
  void make_insideAnObject_isRefusedByItsName(String name) {
    VehicleFile file = shipped(name);
    World world = around(file, new Box());

    assertThatThrownBy(() -> file.make(world, Point.of(3.0, 0.0, 0.0), 0.0, 1))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("it touches shed; expected a free place");
  }

  @Test
  void board_insideAnObject_isRefusedByItsName() {
    VehicleFile file = shipped("ugv/vehicle.xml");
    World world = around(file, new Box());

    assertThatThrownBy(() -> file.board(world, Point.of(3.0, 0.0, 0.0), 0.0, Hazards.none(), 1))
        .hasMessageContaining("it touches shed; expected a free place");
  }
}
