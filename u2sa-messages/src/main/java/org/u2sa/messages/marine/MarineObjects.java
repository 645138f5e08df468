package org.u2sa.messages.marine;

import java.util.Locale;
import org.u2sa.messages.ObjectDescription;

/** Objects by the names that detectors and missions use, such as "orange buoy" or "hot target". */
public final class MarineObjects {
  private MarineObjects() {}

  /**
   * Creates the object of a name, with this name as its type.
   *
   * @param name a kind (buoy, marker, pole, hoop, bin, button, puck, dock, hot target, path
   *     marker), preceded by any colour; any other name yields a plain ObjectDescription
   * @param radiusM half its width [m]; 0 if unknown
   */
  public static ObjectDescription named(String name, double radiusM) {
    return plain(name, radiusM).objectType(name);
  }

  private static ObjectDescription plain(String name, double radiusM) {
    int space = name.lastIndexOf(' ');
    Colour colour = colour(space < 0 ? "" : name.substring(0, space));
    String kind = name.substring(space + 1);
    double width = 2.0 * radiusM;
    if (name.equals("hot target")) {
      return new HotTarget().length(width).width(width);
    } else if (name.endsWith("path marker")) {
      return new PathMarker();
    } else if (kind.equals("button")) {
      Button button = new Button().length(width).width(width);
      return colour == null ? button : button.colour(colour);
    } else if (kind.equals("puck")) {
      return new Puck().radius(radiusM);
    } else if (kind.equals("dock")) {
      return new Dock().width(width);
    } else if (colour != null && (kind.equals("buoy") || kind.equals("marker"))) {
      return new Buoy().colour(colour).radius(radiusM);
    } else if (colour != null && kind.equals("pole")) {
      return new Pole().colour(colour).radius(radiusM);
    } else if (colour != null && kind.equals("bin")) {
      return new Bin().colour(colour).length(width).width(width);
    } else if (colour != null && kind.equals("hoop")) {
      return new Hoop().colour(colour).radius(radiusM);
    }
    return new ObjectDescription();
  }

  /** The colour of a name; null if unknown. */
  private static Colour colour(String name) {
    for (Colour colour : Colour.values()) {
      if (colour.name().toLowerCase(Locale.ROOT).equals(name)) {
        return colour;
      }
    }
    return null;
  }
}
