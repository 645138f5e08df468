/**
 * Messages as people and other programs write them: JSON by the schema of their types, paths to
 * fields, conditions on fields. What is done with a message is not here.
 */
package org.u2sa.gcs.message;
