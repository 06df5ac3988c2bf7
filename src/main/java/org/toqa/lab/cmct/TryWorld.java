package org.toqa.lab.cmct;
import java.util.SplittableRandom;
import org.toqa.planning.*;
import org.toqa.planning.cmct.*;
import org.toqa.lab.experiment.Run;
public class TryWorld {
  public static void main(String[] a) {
    boolean kills = a.length > 2;
    for (long seed = Long.parseLong(a[0]); seed < Long.parseLong(a[1]); seed++) {
      for (int kind = 0; kind < (kills ? 1 : 3); kind++) {
        SplittableRandom random = new SplittableRandom(seed);
        CarryingScene scene = CarryingScene.of(0.15, 10, 0.2, 5, random);
        CarryingSetup setup = CarryingSetup.of(Run.of(1,1), kind < 2, kind == 0, new CmctPlanner());
        CarryingWorld w = new CarryingWorld(scene, setup);
        long t = System.nanoTime();
        java.util.Map<String, Double> back = new java.util.TreeMap<>();
        try {
        while (!w.isDone() && w.time() < 6000) {
          w.step();
          if (kills && random.nextInt(800) == 0) { String n = random.nextInt(3)==0? "R3" : "R" + (1+random.nextInt(2)); w.kill(n); back.put(n, w.time() + random.nextInt(120)); }
          for (String n : java.util.List.copyOf(back.keySet())) if (back.get(n) < w.time()) { back.remove(n); w.revive(n); }
          if (w.boxes() != 10) throw new IllegalStateException("lost a box");
        } } catch (RuntimeException e) { e.printStackTrace(System.out); }
        System.out.printf("seed %d kind %d done %s at %.0f last %.0f idle %.0f wait %.0f nearest %.2f stops %d driven %.0f %.0f deliveries %s ms %d%n", seed, kind, w.isDone(), w.time(), w.lastDelivery(), w.idle(), w.waiting(), w.nearest(), w.stops(), w.driven(true), w.driven(false), w.deliveries(), (System.nanoTime()-t)/1000000);
        if (!w.isDone()) System.out.println(w.describe());
      }
    }
  }
}
