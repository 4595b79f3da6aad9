// All benches at once, with vectors from tests/vectors. Each prints a line PASS STAGE ROWS or FAIL
// STAGE DIFFERENCES; before, its first ten differences, with id and column.
`default_nettype none

module benches;
    wire [12:0] done;

    bench_march march (done[0]);
    bench_weights weights (done[1]);
    bench_sample #(.WIDE(0)) sample8 (done[2]);
    bench_sample #(.WIDE(1), .STAGE("sample16")) sample16 (done[3]);
    bench_separate #(.WIDE(0)) separate8 (done[4]);
    bench_separate #(.WIDE(1), .STAGE("separate16")) separate16 (done[5]);
    bench_under under (done[6]);
    bench_over over (done[7]);
    bench_transmittance transmittance (done[8]);
    bench_transmittance16 transmittance16 (done[9]);
    bench_cell cell_of_sample (done[10]);
    bench_readout readout (done[11]);
    bench_pixel pixel (done[12]);

    always @* if (&done) $finish;
endmodule
