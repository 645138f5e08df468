package org.u2sa.sim.jsbsim;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import java.util.function.DoubleSupplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.xml.XmlElement;

/** The control systems of an aircraft: components that run in the order of the file. */
final class FlightControl {
  private static final Pattern ANGLE = Pattern.compile("fcs/(?!mag-)(.+)-pos-(rad|deg)");
  private static final List<String> SURFACES =
      List.of(
          "elevator", "left-aileron", "right-aileron", "rudder", "flap", "speedbrake", "spoiler");

  /** Operation of a component. */
  @FunctionalInterface
  private interface Law {
    double output(double before, double dtS);
  }

  /** A component with its clip and outputs. */
  private static final class Component {
    private final Law law;
    private final Optional<DoubleSupplier> lowest;
    private final Optional<DoubleSupplier> highest;
    private final List<DoubleConsumer> outputs;
    private double value;

    Component(
        Law law,
        Optional<DoubleSupplier> lowest,
        Optional<DoubleSupplier> highest,
        List<DoubleConsumer> outputs) {
      this.law = law;
      this.lowest = lowest;
      this.highest = highest;
      this.outputs = outputs;
    }

    void step(double dtS) {
      value = law.output(value, dtS);
      lowest.ifPresent(limit -> value = Math.max(limit.getAsDouble(), value));
      highest.ifPresent(limit -> value = Math.min(limit.getAsDouble(), value));
      outputs.forEach(each -> each.accept(value));
    }
  }

  private final PropertyTree properties;
  private final FunctionReader functions;
  private final List<Component> components = new ArrayList<>();

  FlightControl(PropertyTree properties, FunctionReader functions) {
    this.properties = properties;
    this.functions = functions;
    for (String surface : SURFACES) {
      for (String form : List.of("pos-rad", "pos-deg", "pos-norm")) {
        properties.define("fcs/" + surface + "-" + form, 0.0);
      }
      properties.define("fcs/mag-" + surface + "-pos-rad", 0.0);
    }
  }

  /** Adds the components of a {@code flight_control} or {@code system}. */
  void read(XmlElement system) {
    for (XmlElement child : system.children()) {
      switch (child.name()) {
        case "channel" -> read(child);
        case "description", "documentation" -> {
          // for the reader
        }
        case "property" -> declare(child);
        case "function" -> {
          DoubleSupplier function = functions.function(child);
          components.add(
              new Component(
                  (before, dtS) -> function.getAsDouble(),
                  Optional.empty(),
                  Optional.empty(),
                  List.of()));
        }
        default -> components.add(component(system, child));
      }
    }
  }

  /** {@code <property value="1">name</property>}. */
  private void declare(XmlElement property) {
    double value =
        property
            .optionalAttribute("value")
            .map(text -> UnitNumbers.plain(property, text))
            .orElse(0.0);
    properties.define(property.text(), value);
  }

  /** Runs all components once. */
  void step(double dtS) {
    components.forEach(each -> each.step(dtS));
  }

  private Component component(XmlElement parent, XmlElement element) {
    Law law =
        switch (element.name()) {
          case "summer" -> summer(element);
          case "pure_gain" -> gain(element, () -> 1.0);
          case "scheduled_gain" -> gain(element, table(element));
          case "aerosurface_scale" -> scale(element);
          case "kinematic" -> new Kinematic(element, input(element));
          case "fcs_function" -> function(element);
          case "lag_filter" -> lag(element);
          case "deadband" -> deadband(element);
          default ->
              throw parent.unknown(
                  element,
                  List.of(
                      "channel",
                      "property",
                      "function",
                      "summer",
                      "pure_gain",
                      "scheduled_gain",
                      "aerosurface_scale",
                      "kinematic",
                      "fcs_function",
                      "lag_filter",
                      "deadband"));
        };
    Optional<XmlElement> clip = element.child("clipto");
    return new Component(
        law,
        clip.map(each -> parameter(each, "min")),
        clip.map(each -> parameter(each, "max")),
        outputs(element));
  }

  private List<DoubleConsumer> outputs(XmlElement element) {
    List<DoubleConsumer> outputs = new ArrayList<>();
    String name = element.attribute("name").trim();
    outputs.add(
        output(
            name.contains("/") ? name : "fcs/" + name.toLowerCase(Locale.ROOT).replace(' ', '-')));
    element.children("output").forEach(each -> outputs.add(output(each.text())));
    return outputs;
  }

  /** Each surface angle has three properties: radians, degrees and magnitude. */
  private DoubleConsumer output(String name) {
    PropertyTree.Property property = properties.define(name, 0.0);
    Matcher angle = ANGLE.matcher(name);
    if (!angle.matches()) {
      return value -> property.value = value;
    }
    double toRad = angle.group(2).equals("rad") ? 1.0 : Math.toRadians(1.0);
    String surface = angle.group(1);
    PropertyTree.Property rad = properties.define("fcs/" + surface + "-pos-rad", 0.0);
    PropertyTree.Property deg = properties.define("fcs/" + surface + "-pos-deg", 0.0);
    PropertyTree.Property size = properties.define("fcs/mag-" + surface + "-pos-rad", 0.0);
    return value -> {
      rad.value = value * toRad;
      deg.value = Math.toDegrees(rad.value);
      size.value = Math.abs(rad.value);
    };
  }

  private DoubleSupplier input(XmlElement element) {
    List<XmlElement> inputs = element.children("input");
    if (inputs.size() != 1) {
      throw element.error("has " + inputs.size() + " <input>; expected one");
    }
    return properties.read(inputs.get(0).text(), inputs.get(0));
  }

  /** A number, or the property that contains it. */
  private DoubleSupplier parameter(XmlElement parent, String name) {
    XmlElement child = parent.requiredChild(name);
    if (child.text().contains("/")) {
      return properties.read(child.text(), child);
    }
    double value = UnitNumbers.of(child, UnitNumbers.PURE);
    return () -> value;
  }

  private DoubleSupplier parameter(XmlElement parent, String name, double ifAbsent) {
    return parent.child(name).isPresent() ? parameter(parent, name) : () -> ifAbsent;
  }

  private static void refuseOthers(XmlElement element, String... own) {
    List<String> known = new ArrayList<>(List.of("description", "input", "output", "clipto"));
    known.addAll(List.of(own));
    element.refuseUnknownChildren(known.toArray(new String[0]));
  }

  private Law summer(XmlElement element) {
    refuseOthers(element, "bias");
    List<DoubleSupplier> inputs = new ArrayList<>();
    element.children("input").forEach(each -> inputs.add(properties.read(each.text(), each)));
    double bias = UnitNumbers.number(element, "bias", UnitNumbers.PURE, 0.0);
    return (before, dtS) -> bias + inputs.stream().mapToDouble(DoubleSupplier::getAsDouble).sum();
  }

  private DoubleSupplier table(XmlElement element) {
    return functions.table(element.requiredChild("table"));
  }

  private Law gain(XmlElement element, DoubleSupplier schedule) {
    refuseOthers(element, "gain", "table");
    DoubleSupplier input = input(element);
    DoubleSupplier gain = parameter(element, "gain", 1.0);
    return (before, dtS) -> gain.getAsDouble() * schedule.getAsDouble() * input.getAsDouble();
  }

  /** Zero stays zero; positive and negative values are scaled separately. */
  private Law scale(XmlElement element) {
    refuseOthers(element, "gain", "domain", "range", "zero_centered");
    DoubleSupplier input = input(element);
    DoubleSupplier gain = parameter(element, "gain", 1.0);
    XmlElement range = element.requiredChild("range");
    double low = UnitNumbers.number(range, "min", UnitNumbers.PURE);
    double high = UnitNumbers.number(range, "max", UnitNumbers.PURE);
    double[] domain =
        element
            .child("domain")
            .map(
                each ->
                    new double[] {
                      UnitNumbers.number(each, "min", UnitNumbers.PURE),
                      UnitNumbers.number(each, "max", UnitNumbers.PURE)
                    })
            .orElse(new double[] {-1.0, 1.0});
    String centred = element.child("zero_centered").map(XmlElement::text).orElse("1");
    if (centred.equals("0") || centred.equals("false")) {
      double slope = (high - low) / (domain[1] - domain[0]);
      return (before, dtS) ->
          gain.getAsDouble() * (low + (input.getAsDouble() - domain[0]) * slope);
    }
    return (before, dtS) -> {
      double x = input.getAsDouble();
      return gain.getAsDouble()
          * (x > 0.0 ? x / domain[1] * high : x < 0.0 ? x / domain[0] * low : 0.0);
    };
  }

  private Law function(XmlElement element) {
    refuseOthers(element, "function");
    DoubleSupplier function = functions.function(element.requiredChild("function"));
    DoubleSupplier factor = element.child("input").isPresent() ? input(element) : () -> 1.0;
    return (before, dtS) -> factor.getAsDouble() * function.getAsDouble();
  }

  /** C₁ / (s + C₁). */
  private Law lag(XmlElement element) {
    refuseOthers(element, "c1");
    DoubleSupplier input = input(element);
    DoubleSupplier rate = parameter(element, "c1");
    return (before, dtS) ->
        before + (input.getAsDouble() - before) * (1.0 - StrictMath.exp(-rate.getAsDouble() * dtS));
  }

  private Law deadband(XmlElement element) {
    refuseOthers(element, "width", "gain");
    DoubleSupplier input = input(element);
    DoubleSupplier width = parameter(element, "width", 1.0);
    DoubleSupplier gain = parameter(element, "gain", 1.0);
    return (before, dtS) -> {
      double x = input.getAsDouble();
      double half = width.getAsDouble() / 2.0;
      return gain.getAsDouble() * (x < -half ? x + half : x > half ? x - half : 0.0);
    };
  }

  /** Moves between settings, each interval in its own time. */
  private static final class Kinematic implements Law {
    private final DoubleSupplier input;
    private final double[] positions;
    private final double[] times;
    private final boolean isScaled;

    Kinematic(XmlElement element, DoubleSupplier input) {
      refuseOthers(element, "traverse", "noscale");
      this.input = input;
      XmlElement traverse = element.requiredChild("traverse");
      List<XmlElement> settings = traverse.children("setting");
      if (settings.size() < 2) {
        throw traverse.error("has " + settings.size() + " <setting>; expected at least two");
      }
      positions = settings.stream().mapToDouble(each -> pure(each, "position")).toArray();
      times = settings.stream().mapToDouble(each -> pure(each, "time")).toArray();
      isScaled = element.child("noscale").isEmpty();
    }

    private static double pure(XmlElement setting, String name) {
      return UnitNumbers.number(setting, name, UnitNumbers.PURE);
    }

    @Override
    public double output(double before, double dtS) {
      int last = positions.length - 1;
      double wanted = input.getAsDouble() * (isScaled ? positions[last] : 1.0);
      wanted = Math.max(positions[0], Math.min(positions[last], wanted));
      double now = before;
      double leftS = dtS;
      for (int guard = 0; guard <= last && now != wanted; guard++) {
        int upper = 1;
        while (upper < last && (wanted < now ? positions[upper] < now : positions[upper] <= now)) {
          upper++;
        }
        double end = Math.max(positions[upper - 1], Math.min(positions[upper], wanted));
        double rate = (positions[upper] - positions[upper - 1]) / times[upper];
        double neededS = times[upper] > 0.0 ? Math.abs(end - now) / rate : 0.0;
        if (neededS > leftS) {
          return now + Math.copySign(rate * leftS, end - now);
        }
        leftS -= neededS;
        now = end;
      }
      return now;
    }
  }
}
