// What the programs that drive the page share: a count of what is as it should be, and a studio to ask.
import { spawn } from 'node:child_process';

/** Counts what holds, and says what does not. */
export function checks() {
  let passed = 0;
  let failed = 0;
  return {
    check(condition, what) {
      if (condition) ++passed;
      else {
        ++failed;
        console.error(`FAILED: ${what}`);
      }
    },
    /** Prints the counts and ends the program, with 1 if anything failed. */
    end() {
      console.log(`${passed} passed, ${failed} failed`);
      process.exit(failed > 0 ? 1 : 0);
    },
  };
}

/** A studio of the command, and the address that it prints. */
export async function startedStudio(algae, ...words) {
  const studio = spawn(algae, ['studio', ...words], { stdio: ['ignore', 'pipe', 'inherit'] });
  const address = await new Promise((done, fail) => {
    let text = '';
    studio.stdout.on('data', (piece) => {
      text += piece;
      if (text.includes('\n')) done(text.split('\n')[0]);
    });
    studio.on('exit', () => fail(new Error('the studio ended')));
  });
  return { studio, address };
}
