/**
 * Campaigns: many runs of one demo, over seeds and parameters, on all cores, to build confidence in
 * a controller.
 */
package org.u2sa.trials.campaign;
