package org.u2sa.planning.survey;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.Metric;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.shape.CoverageLedger;
import org.u2sa.planning.seen.PlanningPlane;

/** Finds a search area's record, and the cells that are missing, on the planning plane. */
final class LedgerCells {
  private LedgerCells() {}

  static Optional<CoverageLedger> of(SearchArea area, List<ObjectDescription> objects) {
    for (ObjectDescription each : objects) {
      if (each instanceof CoverageLedger && ((CoverageLedger) each).area().equals(area.uid())) {
        return Optional.of((CoverageLedger) each);
      }
    }
    return Optional.empty();
  }

  /** Cells of the area that were not seen at its resolution. */
  static LaneLayout.Cells missing(CoverageLedger ledger, SearchArea area, PlanningPlane plane) {
    Metric metric = Metric.around(ledger.referenceFrame(), ledger.corner());
    List<Integer> numbers = new ArrayList<>();
    int count = ledger.columns() * ledger.rows();
    for (int cell = 0; cell < count; cell++) {
      if (ledger.isInside(cell) && !ledger.isSeen(cell, area.resolution())) {
        numbers.add(cell);
      }
    }
    double[] norths = new double[numbers.size()];
    double[] easts = new double[numbers.size()];
    for (int i = 0; i < norths.length; i++) {
      double x = (numbers.get(i) % ledger.columns() + 0.5) * ledger.cell();
      double y = (numbers.get(i) / ledger.columns() + 0.5) * ledger.cell();
      Point at = plane.ned(ledger.referenceFrame(), metric.point(Point.of(x, y, 0.0)));
      norths[i] = at.x();
      easts[i] = at.y();
    }
    int[] cells = numbers.stream().mapToInt(Integer::intValue).toArray();
    return new LaneLayout.Cells(cells, norths, easts, ledger.cell());
  }
}
