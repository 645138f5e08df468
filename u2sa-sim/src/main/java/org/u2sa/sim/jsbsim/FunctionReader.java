package org.u2sa.sim.jsbsim;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleSupplier;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Collectors;
import org.u2sa.interfaces.xml.XmlElement;

/** Reads expressions of JSBSim's function language. */
final class FunctionReader {
  private static final Map<String, String> SHORT =
      Map.of("p", "property", "v", "value", "t", "table");
  private static final Map<String, DoubleUnaryOperator> UNARY = unary();
  private static final Map<String, DoubleBinaryOperator> BINARY = binary();
  private static final Map<String, DoubleBinaryOperator> CHAIN = chain(); // any number of operands

  private final PropertyTree properties;

  FunctionReader(PropertyTree properties) {
    this.properties = properties;
  }

  private static Map<String, DoubleUnaryOperator> unary() {
    Map<String, DoubleUnaryOperator> map = new HashMap<>();
    map.put("abs", StrictMath::abs);
    map.put("sin", StrictMath::sin);
    map.put("cos", StrictMath::cos);
    map.put("tan", StrictMath::tan);
    map.put("asin", StrictMath::asin);
    map.put("acos", StrictMath::acos);
    map.put("atan", StrictMath::atan);
    map.put("exp", StrictMath::exp);
    map.put("ln", StrictMath::log);
    map.put("sqrt", x -> StrictMath.sqrt(StrictMath.max(0.0, x)));
    map.put("floor", StrictMath::floor);
    map.put("ceil", StrictMath::ceil);
    map.put("integer", x -> x < 0.0 ? StrictMath.ceil(x) : StrictMath.floor(x));
    map.put("fraction", x -> x % 1.0);
    map.put("sign", x -> x < 0.0 ? -1.0 : 1.0);
    map.put("toradians", StrictMath::toRadians);
    map.put("todegrees", StrictMath::toDegrees);
    map.put("not", x -> truth(x == 0.0));
    return map;
  }

  private static Map<String, DoubleBinaryOperator> binary() {
    Map<String, DoubleBinaryOperator> map = new HashMap<>();
    map.put("quotient", (x, y) -> y == 0.0 ? Double.MAX_VALUE : x / y);
    map.put("pow", StrictMath::pow);
    map.put("atan2", StrictMath::atan2);
    map.put("mod", (x, y) -> x % y);
    map.put("fmod", (x, y) -> x % y);
    map.put("lt", (x, y) -> truth(x < y));
    map.put("le", (x, y) -> truth(x <= y));
    map.put("gt", (x, y) -> truth(x > y));
    map.put("ge", (x, y) -> truth(x >= y));
    map.put("eq", (x, y) -> truth(x == y));
    map.put("nq", (x, y) -> truth(x != y));
    return map;
  }

  private static Map<String, DoubleBinaryOperator> chain() {
    Map<String, DoubleBinaryOperator> map = new HashMap<>();
    map.put("product", (x, y) -> x * y);
    map.put("sum", Double::sum);
    map.put("difference", (x, y) -> x - y);
    map.put("min", StrictMath::min);
    map.put("max", StrictMath::max);
    map.put("and", (x, y) -> truth(x != 0.0 && y != 0.0));
    map.put("or", (x, y) -> truth(x != 0.0 || y != 0.0));
    return map;
  }

  private static double truth(boolean value) {
    return value ? 1.0 : 0.0;
  }

  /** The operation in a function; defines the function's name as a property. */
  DoubleSupplier function(XmlElement function) {
    List<DoubleSupplier> parts = parts(function);
    if (parts.size() != 1) {
      throw function.error("has " + parts.size() + " operations; expected one");
    }
    if (function.optionalAttribute("name").isEmpty()) {
      return parts.get(0);
    }
    PropertyTree.Property result = properties.define(function.attribute("name"), 0.0);
    return () -> result.value = parts.get(0).getAsDouble();
  }

  private List<DoubleSupplier> parts(XmlElement parent) {
    List<DoubleSupplier> parts = new ArrayList<>();
    for (XmlElement child : parent.children()) {
      if (!child.name().equals("description")) {
        parts.add(operation(parent, child));
      }
    }
    return parts;
  }

  private DoubleSupplier operation(XmlElement parent, XmlElement element) {
    String name = SHORT.getOrDefault(element.name(), element.name());
    switch (name) {
      case "property":
        element.refuseUnknownAttributes();
        return properties.read(element.text(), element);
      case "value":
        double constant = UnitNumbers.plain(element, element.text());
        return () -> constant;
      case "pi":
        return () -> StrictMath.PI;
      case "table":
        return table(element);
      case "ifthen":
        List<DoubleSupplier> three = parts(element, 3);
        return () -> three.get(three.get(0).getAsDouble() != 0.0 ? 1 : 2).getAsDouble();
      case "avg":
        List<DoubleSupplier> all = parts(element);
        return () -> all.stream().mapToDouble(DoubleSupplier::getAsDouble).average().orElse(0.0);
      default:
        return calculation(parent, element);
    }
  }

  private DoubleSupplier calculation(XmlElement parent, XmlElement element) {
    String name = element.name();
    if (UNARY.containsKey(name)) {
      DoubleSupplier only = parts(element, 1).get(0);
      DoubleUnaryOperator operator = UNARY.get(name);
      return () -> operator.applyAsDouble(only.getAsDouble());
    }
    if (BINARY.containsKey(name)) {
      List<DoubleSupplier> two = parts(element, 2);
      DoubleBinaryOperator operator = BINARY.get(name);
      return () -> operator.applyAsDouble(two.get(0).getAsDouble(), two.get(1).getAsDouble());
    }
    if (CHAIN.containsKey(name)) {
      return chained(CHAIN.get(name), parts(element), element);
    }
    TreeSet<String> known = new TreeSet<>(SHORT.values());
    known.addAll(List.of("pi", "ifthen", "avg"));
    known.addAll(UNARY.keySet());
    known.addAll(BINARY.keySet());
    known.addAll(CHAIN.keySet());
    throw parent.unknown(element, List.copyOf(known));
  }

  private static DoubleSupplier chained(
      DoubleBinaryOperator operator, List<DoubleSupplier> parts, XmlElement element) {
    if (parts.isEmpty()) {
      throw element.error("is empty; expected operands");
    }
    DoubleSupplier[] each = parts.toArray(new DoubleSupplier[0]);
    return () -> {
      double result = each[0].getAsDouble();
      for (int i = 1; i < each.length; i++) {
        result = operator.applyAsDouble(result, each[i].getAsDouble());
      }
      return result;
    };
  }

  private List<DoubleSupplier> parts(XmlElement element, int count) {
    List<DoubleSupplier> parts = parts(element);
    if (parts.size() != count) {
      throw element.error("has " + parts.size() + " operands; expected " + count);
    }
    return parts;
  }

  /** A table with its independent variables. */
  DoubleSupplier table(XmlElement element) {
    element.refuseUnknownChildren("description", "independentVar", "tableData");
    List<XmlElement> keys =
        element.children("independentVar").stream()
            .sorted( // the row's variable first
                (a, b) ->
                    b.optionalAttribute("lookup")
                        .orElse("row")
                        .compareTo(a.optionalAttribute("lookup").orElse("row")))
            .collect(Collectors.toList());
    LookupTable table = LookupTable.read(element);
    if (keys.size() != (table.isMatrix() ? 2 : 1)) {
      throw element.error(
          "has " + keys.size() + " <independentVar>; expected " + (table.isMatrix() ? 2 : 1));
    }
    DoubleSupplier row = properties.read(keys.get(0).text(), keys.get(0));
    if (!table.isMatrix()) {
      return () -> table.at(row.getAsDouble(), 0.0);
    }
    DoubleSupplier column = properties.read(keys.get(1).text(), keys.get(1));
    return () -> table.at(row.getAsDouble(), column.getAsDouble());
  }
}
