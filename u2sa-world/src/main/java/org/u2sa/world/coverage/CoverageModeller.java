package org.u2sa.world.coverage;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.shape.CoverageLedger;
import org.u2sa.messages.shape.ImageFootprint;
import org.u2sa.service.handover.HandOver;
import org.u2sa.world.modeller.Modeller;
import org.u2sa.world.modeller.Sighting;

/**
 * Records for each search area of the mission which cells were seen, from which image, at which
 * resolution and angle, and publishes it as a {@link CoverageLedger}. Images taken before the
 * mission named the area do not count.
 */
public final class CoverageModeller implements Modeller {
  private record Variables(
      @Variable(unit = "m", min = 0.5, max = 100, ifAbsent = 5)
          @Description("Side of the cells into which search areas are divided.")
          double coverageCell,
      @Variable(unit = "m", min = 0, max = 50, ifAbsent = 2)
          @Description(
              "Margin by which the ground shown by an image is reduced on all sides, to allow for errors of the vehicle's position and attitude.")
          double coverageMargin) {}

  private static final int MAX_AREAS = 20;

  private final Settings<Variables> settings;
  private final Map<String, AreaCells> areas = new LinkedHashMap<>();
  private long images;
  private int refused;

  /**
   * @param configuration configuration of the World Modeler
   */
  public CoverageModeller(Configurator configuration) {
    settings = configuration.settings(Variables.class);
  }

  @Override
  public void goals(GoalList goals) {
    Stream.concat(goals.goals().stream(), goals.upcoming().stream())
        .filter(SearchArea.class::isInstance)
        .map(SearchArea.class::cast)
        .forEach(this::area);
  }

  private void area(SearchArea area) {
    AreaCells known = areas.get(area.uid());
    if (known != null && known.isOf(area)) {
      return;
    }
    if (known == null && areas.size() >= MAX_AREAS || area.corners().size() < 3) {
      refused++;
      return;
    }
    areas.put(area.uid(), new AreaCells(area, settings.get().coverageCell()));
  }

  @Override
  public void footprint(ImageFootprint seen) {
    images++;
    areas.values().forEach(area -> area.see(seen, settings.get().coverageMargin()));
  }

  @Override
  public List<ObjectDescription> objects(Sighting now) {
    List<ObjectDescription> ledgers = new ArrayList<>();
    areas.values().forEach(area -> ledgers.add(area.ledger()));
    return ledgers;
  }

  @Override
  public String remark() {
    return areas.size()
        + " areas, "
        + images
        + " images"
        + (refused == 0 ? "" : ", " + refused + " areas rejected");
  }

  @Override
  public void handOver(HandOver state, Sighting now) {
    List<SearchArea> goals = new ArrayList<>();
    List<CoverageLedger> ledgers = new ArrayList<>();
    areas.values().forEach(area -> goals.add(area.goal()));
    areas.values().forEach(area -> ledgers.add(area.ledger()));
    state.messages("SEARCH AREAS", goals).messages("COVERAGE", ledgers);
  }

  @Override
  public void takeOver(HandOver state, Sighting now) {
    List<SearchArea> goals = state.messages("SEARCH AREAS", SearchArea.class);
    List<CoverageLedger> ledgers = state.messages("COVERAGE", CoverageLedger.class);
    for (int i = 0; i < Math.min(goals.size(), ledgers.size()); i++) {
      AreaCells cells = new AreaCells(goals.get(i), ledgers.get(i).cell());
      cells.restore(ledgers.get(i));
      areas.put(goals.get(i).uid(), cells);
    }
  }
}
