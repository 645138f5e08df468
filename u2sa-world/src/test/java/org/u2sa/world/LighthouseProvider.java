package org.u2sa.world;

import java.util.List;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.Modeller;
import org.u2sa.world.modeller.ModellerProvider;
import org.u2sa.world.modeller.Sighting;

/** An extension's modeller, found as one of another jar would be: it knows one lighthouse. */
public final class LighthouseProvider implements ModellerProvider {
  record Variables(
      @Variable(unit = "m", ifAbsent = 100) @Description("Where the lighthouse stands, northward.")
          double lighthouse) {}

  @Override
  public String name() {
    return "LIGHTHOUSE";
  }

  @Override
  public Modeller modeller(Configurator configuration) {
    Settings<Variables> tuning = configuration.settings(Variables.class);
    return new Modeller() {
      @Override
      public List<ObjectDescription> objects(Sighting now) {
        return List.of(
            new ObjectDescription()
                .uid("lighthouse")
                .referenceFrame(ReferenceFrame.LOCAL_NED)
                .x(tuning.get().lighthouse())
                .y(0.0));
      }

      @Override
      public String remark() {
        return "shines";
      }
    };
  }
}
