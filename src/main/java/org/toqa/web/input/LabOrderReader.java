package org.toqa.web.input;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.lab.Experiments;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.experiment.Parameter;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.experiment.Value;
import org.toqa.lab.record.LabOrder;

/** Reads which experiment is to be done, and how. */
public final class LabOrderReader {
  /** In a form, before the name of a parameter. */
  public static final String PARAMETER = "parameter.";

  /** A larger seed is not the same number in every program that reads JSON. */
  private static final double MAX_SEED = 9_007_199_254_740_991.0;

  private final Fields fields;

  private LabOrderReader(Fields fields) {
    this.fields = fields;
  }

  /** What it reads means something only where no sentence was filed. */
  public static LabOrder readForm(Fields fields) {
    return new LabOrderReader(fields).read(name -> fields, PARAMETER::concat);
  }

  /** The same, where parameters are an object in it. */
  public static LabOrder readJson(Fields fields) {
    return new LabOrderReader(fields).read(name -> object(fields, name), Function.identity());
  }

  private static @Nullable Fields object(Fields fields, String name) {
    if (fields.has(name)) {
      return fields.object(name);
    }
    var _ = fields.text(name); // so that who wrote another field is told of this one
    return null;
  }

  private LabOrder read(
      Function<String, @Nullable Fields> object, Function<String, String> nameOfParameter) {
    String name = fields.text("experiment");
    Optional<Experiment> experiment = name == null ? Optional.empty() : Experiments.named(name);
    if (experiment.isEmpty()) {
      refuse(
          fields,
          "experiment",
          "error.laboratory.experiment",
          Experiments.all().stream().map(Experiment::name).collect(Collectors.joining(", ")));
    }
    double seed = whole("seed", -MAX_SEED, MAX_SEED);
    double runs = whole("runs", 1, Run.MOST_RUNS);
    Map<String, Double> values = new TreeMap<>();
    Fields given = object.apply("parameters");
    if (given != null && experiment.isPresent()) {
      for (Parameter parameter : experiment.get().parameters()) {
        readParameter(given, nameOfParameter.apply(parameter.name()), parameter, values);
      }
      given.refuseUnknown();
    }
    fields.refuseUnknown();
    return new LabOrder(name == null ? "" : name, (long) seed, (int) runs, values);
  }

  /** One where nothing is given. */
  private double whole(String field, double least, double most) {
    Double given = fields.number(field);
    if (given == null) {
      return 1;
    }
    if (given != Math.rint(given) || !(given >= least && given <= most)) {
      refuse(fields, field, "error.laboratory.whole", text(least), text(most));
      return 1;
    }
    return given;
  }

  private static void readParameter(
      Fields given, String field, Parameter parameter, Map<String, Double> values) {
    Double value = given.number(field);
    if (value == null || value == parameter.value()) {
      return;
    }
    if (parameter.allows(value)) {
      values.put(parameter.name(), value);
    } else {
      refuse(
          given, field, "error.laboratory.range", text(parameter.least()), text(parameter.most()));
    }
  }

  private static void refuse(Fields fields, String field, String key, Object... values) {
    fields.errors().add(fields.path(field), fields.texts().get(key, values));
  }

  private static String text(double number) {
    return number == Math.rint(number) ? Long.toString((long) number) : Value.of(number, "").text();
  }
}
