package org.toqa.planning;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.PriorityQueue;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

class BucketQueuePropertyTest {
  private static final int LARGEST_STEP = BucketQueue.SPAN - 1;

  /** Against the library's queue: keys come in order, and none that is above the limit. */
  @Property(tries = 300)
  void keysComeInOrderUpToTheLimit(
      @ForAll @IntRange(max = 5_000) int firstKey, @ForAll @IntRange(min = 1) int seed) {
    Random random = new Random(seed);
    BucketQueue queue = new BucketQueue();
    queue.clear(3);
    queue.push(0, 3 + random.nextInt(BucketQueue.SPAN)); // what is left of a search before
    queue.clear(firstKey);
    PriorityQueue<Integer> keys = new PriorityQueue<>();
    int[] keyOfItem = new int[2_000];
    int least = firstKey;
    for (int item = 0; item < keyOfItem.length; ) {
      if (random.nextInt(5) < 3) {
        keyOfItem[item] = least + random.nextInt(random.nextBoolean() ? 3 : LARGEST_STEP + 1);
        keys.add(keyOfItem[item]);
        queue.push(item, keyOfItem[item]);
        item++;
      } else {
        int limit = least + random.nextInt(LARGEST_STEP);
        int popped = queue.pop(limit);
        if (keys.isEmpty() || keys.element() > limit) {
          assertEquals(-1, popped);
        } else {
          least = keys.remove();
          assertEquals(least, keyOfItem[popped]);
          assertEquals(least, queue.key());
        }
      }
      assertEquals(keys.isEmpty(), queue.isEmpty());
    }
    while (!keys.isEmpty()) {
      assertEquals(keys.remove(), keyOfItem[queue.pop(Integer.MAX_VALUE)]);
    }
    assertTrue(queue.isEmpty());
  }
}
