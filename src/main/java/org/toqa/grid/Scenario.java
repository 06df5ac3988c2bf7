package org.toqa.grid;

/**
 * One query of a MovingAI scenario file.
 *
 * @param bucket group of queries of about the same length, from 0; of 4 cells a bucket
 * @param map the map file's name, as the file has it
 * @param width cells
 * @param height cells
 * @param optimal length in cells of the shortest octile path that cuts no corner
 */
public record Scenario(
    int bucket, String map, int width, int height, Cell start, Cell goal, double optimal) {}
