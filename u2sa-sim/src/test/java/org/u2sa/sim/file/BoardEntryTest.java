package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.sim.ground.AckermannParameters;
import org.u2sa.sim.ground.MiniMolle;
import org.u2sa.sim.ground.Truck;
import org.u2sa.sim.sensor.CompassParameters;
import org.u2sa.sim.sensor.GpsParameters;

class BoardEntryTest {
  @Test
  void load_miniMolle_hasTheWiringAndTheDevicesOfTheDocumentation() {
    BoardEntry board = VehicleFile.load(Vehicles.MINI_MOLLE).board().orElseThrow();

    assertThat(board.wiring()).isEqualTo(MiniMolle.Wiring.standard());
    assertThat(board.gps()).isEqualTo(GpsParameters.survey());
    assertThat(board.compass().apply(0.1)).isEqualTo(CompassParameters.calibrated(0.1));
  }

  @Test
  void load_truck_hasTheParametersOfTheVehicleInCode() {
    AckermannParameters read =
        ((AckermannModel) VehicleFile.load(Vehicles.TRUCK).model()).parameters();
    assertThat(read).isEqualTo(Truck.with(read.payload()));
  }
}
