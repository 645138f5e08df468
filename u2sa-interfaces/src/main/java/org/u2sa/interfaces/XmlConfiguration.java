package org.u2sa.interfaces;

import java.io.IOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.AbstractMap.SimpleImmutableEntry;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.messages.contract.ConfigurationVariable;

/**
 * The configuration of one service in its own XML file (thesis 3.2.1.1, 4.5.1.2, 4.5.3):
 *
 * <pre>{@code
 * <configuration>
 *   <variable name="COMMUNICATION MANAGER IP" type="string" value="localhost"/>
 *   <variable name="BANK LIMIT" type="double" value="30" unit="deg" min="0" max="60"/>
 * </configuration>
 * }</pre>
 *
 * <p>The file is read once. A change rewrites the one value in the text that the file then has: its
 * comments, its order and what others changed meanwhile stay. One process writes a file, any number
 * of threads may call.
 */
public final class XmlConfiguration implements Configurator {
  private final String origin;
  private final Optional<Path> file;
  private final Map<String, FileVariable> stated;
  private final Set<String> overridden = new HashSet<>();
  private final Set<String> tolerated = new HashSet<>();
  private final Map<String, Variable<?>> declared = new LinkedHashMap<>();
  private final Map<String, Object> values = new LinkedHashMap<>();

  private XmlConfiguration(String origin, Optional<Path> file, Map<String, FileVariable> stated) {
    this.origin = origin;
    this.file = file;
    this.stated = new LinkedHashMap<>(stated);
    stated.forEach((name, variable) -> values.put(name, variable.value()));
  }

  /**
   * Reads a configuration file.
   *
   * @throws ConfigurationException if it is missing, unreadable or not such a file; names file,
   *     line, variable, value and what was expected
   */
  public static XmlConfiguration load(Path file) {
    return new XmlConfiguration(
        file.toString(), Optional.of(file), ConfigurationFile.read(file).variables());
  }

  /**
   * A configuration without a file: changes last as long as the object.
   *
   * @param name how messages name it
   * @param values Integer, Double, Boolean or String by variable, in the declared units
   * @throws IllegalArgumentException if a value is of another class
   */
  public static XmlConfiguration inMemory(String name, Map<String, ?> values) {
    Map<String, FileVariable> stated = new LinkedHashMap<>();
    values.forEach(
        (variable, value) -> stated.put(variable, FileVariable.inMemory(name, variable, value)));
    return new XmlConfiguration(name, Optional.empty(), stated);
  }

  /**
   * Sets a variable for as long as this object lives, whatever the file says, and leaves the file
   * alone. To be called before the variable is declared.
   *
   * @param value Integer, Double, Boolean or String, in the declared unit
   * @throws IllegalArgumentException if the value is of another class
   */
  public synchronized void override(String variableName, Object value) {
    FileVariable statement = FileVariable.inMemory(origin, variableName, value);
    overridden.add(variableName);
    stated.put(variableName, statement);
    values.put(variableName, statement.value());
  }

  /**
   * This configuration, as it is now, for a service of another class that takes the place of the
   * present one: what only the present one declares need not be declared again.
   */
  public synchronized XmlConfiguration forSuccessor() {
    XmlConfiguration copy = new XmlConfiguration(origin, file, stated);
    copy.overridden.addAll(overridden);
    copy.tolerate(tolerated());
    return copy;
  }

  /** Lets variables of the file be there though nobody declares them. */
  public synchronized void tolerate(Collection<String> variableNames) {
    tolerated.addAll(variableNames);
  }

  /**
   * The variables that a successor need not declare: all that were declared or tolerated so far.
   */
  public synchronized Set<String> tolerated() {
    Set<String> names = new LinkedHashSet<>(tolerated);
    names.addAll(declared.keySet());
    return names;
  }

  /** Variables of the file that are tolerated and that nobody declares: they have no effect. */
  public synchronized List<String> withoutEffect() {
    List<String> names = new ArrayList<>(stated.keySet());
    names.removeIf(name -> declared.containsKey(name) || !tolerated.contains(name));
    return names;
  }

  /**
   * The file that a variable names: a relative path is relative to the configuration file, so that
   * a system runs from any working directory; without a file, to the working directory.
   */
  public Path resolve(String path) {
    return file.map(own -> own.resolveSibling(path).normalize()).orElseGet(() -> Paths.get(path));
  }

  /** The file, or the name of a configuration without one. */
  public String origin() {
    return origin;
  }

  @Override
  public synchronized Object getVariable(String variableName) {
    Object value = values.get(variableName);
    if (value == null) {
      throw new ConfigurationException(origin + ", " + unknown(variableName));
    }
    return value;
  }

  @Override
  public synchronized <T> T getVariable(Variable<T> variable) {
    String name = variable.name();
    if (declared.get(name) != variable) {
      FileVariable statement = stated.get(name);
      if (statement != null && (!file.isPresent() || overridden.contains(name))) {
        statement = statement.withType(variable.type());
      }
      BoundVariable bound =
          new BoundVariable(origin, name, Optional.of(variable), Optional.ofNullable(statement));
      values.put(name, bound.value());
      declared.put(name, variable);
      if (statement != null) {
        stated.put(name, statement);
      }
    }
    return variable.cast(values.get(name));
  }

  /**
   * Refuses variables of the file that no service declared: most are misspelt.
   *
   * @throws ConfigurationException naming the first of them and the nearest declared name
   */
  public synchronized void refuseUndeclared() {
    for (FileVariable variable : stated.values()) {
      if (!declared.containsKey(variable.name()) && !tolerated.contains(variable.name())) {
        throw variable.error(
            "no service declares it" + NearestNames.didYouMean(variable.name(), declared.keySet()));
      }
    }
  }

  /** What has been declared so far, in that order; the list is the caller's own. */
  public synchronized List<Variable<?>> declared() {
    return new ArrayList<>(declared.values());
  }

  @Override
  public boolean setVariable(String variableName, Object value) {
    return !change(variableName, value).isPresent();
  }

  /**
   * {@link #setVariable} that says why not.
   *
   * @return empty if the variable has the new value, in memory and on file; otherwise the reason
   *     for the log, and the old value stays
   */
  public synchronized Optional<String> change(String variableName, Object value) {
    try {
      if (!values.containsKey(variableName)) {
        return Optional.of(origin + ", " + unknown(variableName));
      }
      Optional<ConfigurationFile> now = file.map(ConfigurationFile::read);
      Optional<FileVariable> before =
          now.isPresent()
              ? now.get().variable(variableName)
              : Optional.ofNullable(stated.get(variableName));
      BoundVariable bound = bound(variableName, before);
      FileVariable after = bound.restated(bound.checked(value));
      Object newValue = bound(variableName, Optional.of(after)).value();
      if (now.isPresent()) {
        now.get().write(after);
      }
      stated.put(variableName, after);
      values.put(variableName, newValue);
      return Optional.empty();
    } catch (ConfigurationException e) {
      return Optional.of(e.getMessage());
    } catch (IllegalArgumentException e) {
      return Optional.of(origin + ", variable \"" + variableName + "\": " + e.getMessage());
    } catch (IOException e) {
      return Optional.of(
          origin
              + ", variable \""
              + variableName
              + "\": cannot be written, the old value stays: "
              + e);
    }
  }

  /**
   * Why {@link #setVariable} would refuse this value or text; empty if it would try to write it.
   */
  public synchronized Optional<String> reasonOfRefusal(String variableName, Object valueOrText) {
    if (!values.containsKey(variableName)) {
      return Optional.of(origin + ", " + unknown(variableName));
    }
    try {
      bound(variableName, Optional.ofNullable(stated.get(variableName))).checked(valueOrText);
      return Optional.empty();
    } catch (ConfigurationException e) {
      return Optional.of(e.getMessage());
    }
  }

  @Override
  public synchronized ArrayList<Map.Entry<String, Object>> enumerateFields() {
    ArrayList<Map.Entry<String, Object>> fields = new ArrayList<>();
    values.forEach((name, value) -> fields.add(new SimpleImmutableEntry<>(name, value)));
    return fields;
  }

  /** Every variable with type, value, unit, limits and meaning, for a configuration response. */
  public synchronized List<ConfigurationVariable> describe() {
    List<ConfigurationVariable> all = new ArrayList<>();
    values.forEach(
        (name, value) ->
            all.add(bound(name, Optional.ofNullable(stated.get(name))).described(value)));
    return all;
  }

  private BoundVariable bound(String name, Optional<FileVariable> statement) {
    Optional<Variable<?>> declaration = Optional.ofNullable(declared.get(name));
    if (!declaration.isPresent() && !statement.isPresent()) {
      throw new ConfigurationException(
          origin + ", variable \"" + name + "\": no longer stands in the file");
    }
    return new BoundVariable(origin, name, declaration, statement);
  }

  private String unknown(String name) {
    Set<String> known = new LinkedHashSet<>(values.keySet());
    return "variable \"" + name + "\": there is none" + NearestNames.didYouMean(name, known);
  }
}
