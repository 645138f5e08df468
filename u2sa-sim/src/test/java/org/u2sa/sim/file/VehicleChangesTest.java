package org.u2sa.sim.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.sim.sensor.GpsParameters;

class VehicleChangesTest {
  @Test
  void load_otherValues_replaceThoseOfTheFileAndMayBeNew() {
    VehicleFile file =
        VehicleFile.load(
            Vehicles.MINI_MOLLE,
            Map.of("body/mass", "25", "differential/payload", "3", "ioio/gps/@preset", "phone"));

    assertThat(file.massKg()).isEqualTo(25.0);
    assertThat(((DifferentialModel) file.model()).parameters().payload().massKg()).isEqualTo(3.0);
    assertThat(file.board().orElseThrow().gps()).isEqualTo(GpsParameters.phone());
  }

  @Test
  void load_placeThatIsNotThere_isRefused() {
    assertThatThrownBy(() -> VehicleFile.load(Vehicles.MINI_MOLLE, Map.of("vessel/drag", "1")))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("has no <vessel>, which a change of \"vessel/drag\" needs");
  }

  @Test
  void load_valueOutOfItsRange_isRefusedWithTheLineOfTheFile() {
    assertThatThrownBy(() -> VehicleFile.load(Vehicles.MINI_MOLLE, Map.of("body/mass", "-1")))
        .hasMessageContaining("vehicle.xml, line 8, <mass>: -1.0 kg: expected above 0");
  }
}
