package org.u2sa.world.grid;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.locationtech.jts.algorithm.locate.IndexedPointInAreaLocator;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Location;

/** Which cells are inside, against JTS's point in polygon. */
class PolygonFillProperties {
  private static final int SIDE = 40;

  @Property(tries = 300)
  void fill_starOfAnyShape_hasTheCellsWhoseMiddleIsInside(
      @ForAll @IntRange(min = 3, max = 60) int corners, @ForAll long seed) {
    Random random = new Random(seed);
    double x = SIDE * random.nextDouble();
    double y = SIDE * random.nextDouble();
    Coordinate[] star = new Coordinate[corners + 1];
    for (int i = 0; i < corners; i++) {
      double angle = 2.0 * Math.PI * i / corners;
      double range = 1.0 + 30.0 * random.nextDouble();
      star[i] = new Coordinate(x + range * Math.cos(angle), y + range * Math.sin(angle));
    }
    star[corners] = star[0].copy();

    int[] filled = new int[SIDE * SIDE];
    PolygonFill polygon = new PolygonFill(SIDE);
    for (int i = 0; i < corners; i++) {
      polygon.edge(star[i].x, star[i].y, star[i + 1].x, star[i + 1].y);
    }
    polygon.fill(
        (row, from, to) -> {
          for (int column = from; column <= to; column++) {
            filled[row * SIDE + column]++;
          }
        });

    IndexedPointInAreaLocator inside =
        new IndexedPointInAreaLocator(new GeometryFactory().createPolygon(star));
    for (int row = 0; row < SIDE; row++) {
      for (int column = 0; column < SIDE; column++) {
        int where = inside.locate(new Coordinate(column + 0.5, row + 0.5));
        if (where != Location.BOUNDARY) {
          assertThat(filled[row * SIDE + column])
              .as("cell %d, %d", column, row)
              .isEqualTo(where == Location.INTERIOR ? 1 : 0);
        }
      }
    }
  }
}
