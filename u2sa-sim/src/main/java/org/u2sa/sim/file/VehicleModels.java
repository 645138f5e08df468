package org.u2sa.sim.file;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import org.u2sa.sim.file.element.FileElement;

/** The kinds of dynamics, by their elements in vehicle files. */
final class VehicleModels {
  private static final Map<String, BiFunction<FileElement, Body, VehicleModel>> KINDS = kinds();

  private VehicleModels() {}

  private static Map<String, BiFunction<FileElement, Body, VehicleModel>> kinds() {
    Map<String, BiFunction<FileElement, Body, VehicleModel>> kinds = new LinkedHashMap<>();
    kinds.put("differential", DifferentialModel::read);
    kinds.put("skidSteer", SkidSteerModel::read);
    kinds.put("ackermann", AckermannModel::read);
    kinds.put("vessel", VesselModel::read);
    kinds.put("multirotor", MultirotorModel::read);
    kinds.put("fixedWing", FixedWingModel::read);
    kinds.put("cessna172", Cessna172Model::read);
    kinds.put("jsbsim", JsbsimModel::read);
    kinds.put("fixedBase", FixedBaseModel::read);
    return kinds;
  }

  /**
   * Reads the only dynamics of a vehicle.
   *
   * @throws org.u2sa.interfaces.BadInputException if there is not exactly one
   */
  static VehicleModel read(FileElement vehicle, Body body) {
    List<FileElement> found =
        KINDS.keySet().stream()
            .flatMap(kind -> vehicle.parts(kind).stream())
            .collect(Collectors.toList());
    if (found.size() != 1) {
      throw vehicle
          .xml()
          .error(
              "has "
                  + found.size()
                  + " elements of dynamics; expected exactly one of "
                  + String.join(", ", KINDS.keySet()));
    }
    FileElement dynamics = found.get(0);
    VehicleModel model =
        dynamics.made(() -> KINDS.get(dynamics.xml().name()).apply(dynamics, body));
    dynamics.end();
    return model;
  }
}
